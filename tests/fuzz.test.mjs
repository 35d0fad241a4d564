// The JavaScript face under random calls, and random runs natively and here. Other seeds, and longer: tests/fuzz.mjs.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { callFace, compareRuns } from './fuzz.mjs'

test('200,000 random calls return or say what is wrong', () => {
  const { made, refused, again } = callFace({ seed: 20, calls: 200_000 })
  assert.ok(again > 30, `${again} runs were repeated`)
  assert.ok(refused > made / 20 && refused < made / 2, `${refused} of them refused`)
})

test('300 random runs end as natively, or are refused as natively', () => {
  const { runs, refused } = compareRuns({ seed: 20, runs: 300, program: process.env.FORAGE ?? 'target/debug/forage' })
  assert.ok(refused > 10 && refused < runs / 2, `${refused} of them refused`)
})
