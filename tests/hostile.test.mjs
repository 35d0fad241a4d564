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
