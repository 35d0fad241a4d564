// Code that means no good, under Node. The browsers' engines run the same: www/tests/hostile.test.mjs.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { registerCode } from '../pkg/isolate.node.js'
import { Session } from '../pkg/node.js'
import { attack } from './hostile.mjs'

test('hostile code stays inside', async () => {
  const { wrong, attacks } = await attack({ registerCode, Session })
  assert.deepEqual(wrong, [])
  assert.ok(attacks > 60, `${attacks} codes`)
})

test('a machine on which each look at the clock takes two seconds has time for what is not the author’s', async (context) => {
  const now = performance.now.bind(performance)
  let looks = 0
  context.mock.method(performance, 'now', () => {
    looks += 1
    return now() + 2000 * looks
  })
  const { name } = await registerCode(`register({
    name: 'calm',
    kinds: ['function'],
    start: ({ box, evaluate }) => ({ x: box.low, cost: evaluate(box.low) }),
    advance: (state) => state,
    best: ({ x, cost }) => ({ position: x, cost }),
  })`)
  assert.equal(name, 'calm')
})
