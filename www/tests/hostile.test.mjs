// Code that means no good, in three engines.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { chromium, ENGINES } from './support/engines.mjs'
import { staticHost } from './support/static.mjs'

const ROOT = fileURLToPath(new URL('../..', import.meta.url))
const PATIENCE = 240_000

const server = staticHost(ROOT)
before(() => new Promise((listening) => server.listen(0, '127.0.0.1', listening)))
after(() => server.close())

for (const [name, start] of Object.entries({ chromium, ...ENGINES })) {
  test(`hostile code stays inside: ${name}`, async () => {
    const browser = await start()
    try {
      await browser.open(`http://127.0.0.1:${server.address().port}/tests/support/hostile.html`)
      const began = Date.now()
      let found
      while (!found && Date.now() - began < PATIENCE) {
        await new Promise((passed) => setTimeout(passed, 500))
        found = await browser.run(() => globalThis.attacked ?? null)
      }
      assert.ok(found, 'it comes to an end')
      const { wrong, attacks } = JSON.parse(found)
      assert.deepEqual(wrong, [])
      assert.ok(attacks > 60, `${attacks} codes`)
    } finally {
      await browser.close()
    }
  })
}
