// The JavaScript face under random calls (other seeds, and longer: tests/fuzz.mjs), and random runs natively and here (more of them, and
// in browsers: tests/hosts.mjs).
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { callFace } from './fuzz.mjs'
import { compareHosts } from './hosts.mjs'

test('100,000 random calls return or say what is wrong', () => {
  const { made, refused, again } = callFace({ seed: 20, calls: 100_000 })
  assert.ok(again > 30, `${again} runs were repeated`)
  assert.ok(refused > made / 20 && refused < made / 2, `${refused} of them refused`)
})

test('1,000 random runs end as natively, or are refused as natively', async () => {
  const { rows, differing } = await compareHosts({ seed: 20, runs: 1000, hosts: ['debug', 'node'] })
  assert.deepEqual(differing, [])
  for (const { refused } of rows) assert.ok(refused > 30 && refused < 500, `${refused} of them refused`)
})
