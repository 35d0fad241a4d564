// Code that means no good, in three engines.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { chromium, ENGINES } from './support/engines.mjs'
import { staticHost } from './support/static.mjs'

const ROOT = fileURLToPath(new URL('../..', import.meta.url))
/** As long as all of it may take, in milliseconds: it takes about 35 s. */
const PATIENCE = 120_000
/** As long as an engine may take until it tries the first code, in milliseconds: it takes less than a second. */
const START = 30_000
/** An engine that never begins, or stops answering on a busy machine, is started once more: a code that stops it does so again. */
const ATTEMPTS = { begun: 2, silent: 4 }

const server = staticHost(ROOT)
before(() => new Promise((listening) => server.listen(0, '127.0.0.1', listening)))
after(() => server.close())

/** What the suite found in an engine, or which code it was at when time was up. */
async function attacked(start) {
  const browser = await start()
  try {
    await browser.open(`http://127.0.0.1:${server.address().port}/tests/support/hostile.html`)
    const began = Date.now()
    let seen = {}
    const limit = () => (seen.trying ? PATIENCE : START)
    while (!seen.attacked && Date.now() - began < limit()) {
      await new Promise((passed) => setTimeout(passed, 500))
      seen = await browser.run(() => ({ attacked: globalThis.attacked, trying: globalThis.trying, loaded: globalThis.loaded }))
    }
    return seen
  } finally {
    await browser.close()
  }
}

for (const [name, start] of Object.entries({ chromium, ...ENGINES })) {
  test(`hostile code stays inside: ${name}`, async (context) => {
    const tries = { begun: 0, silent: 0 }
    let seen = {}
    while (!seen.attacked && tries.begun < ATTEMPTS.begun && tries.silent < ATTEMPTS.silent) {
      seen = await attacked(start)
      tries[seen.trying ? 'begun' : 'silent'] += 1
      if (!seen.attacked) context.diagnostic(`no end; it was at: ${seen.trying ?? seen.loaded ?? 'a thread that says nothing'}`)
    }
    assert.ok(seen.attacked, `it comes to an end; it was at: ${seen.trying ?? seen.loaded}`)
    const { wrong, attacks } = JSON.parse(seen.attacked)
    assert.deepEqual(wrong, [])
    assert.ok(attacks > 60, `${attacks} codes`)
  })
}
