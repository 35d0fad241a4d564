// The smoke set in the two other engines: load, play, seek, the hashes of five runs, an edit, an arm in space, a file from a disk.
// The hashes are those of the same core under Node.
import assert from 'node:assert/strict'
import { after, before, describe, test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { Session } from '../../pkg/node.js'
import { ENGINES } from './support/engines.mjs'
import { staticHost } from './support/static.mjs'

const DIST = fileURLToPath(new URL('../dist', import.meta.url))
const FILE = new URL('../dist-single/forage.html', import.meta.url).href
const PATIENCE = 60_000

const RUNS = [
  [{ planner: 'wcpso', scene: 'wcpso-discs', seed: 3 }, 20],
  [{ planner: 'aco-direction', scene: 'ant-bat-30', seed: 2 }, 5],
  [{ planner: 'bat', scene: 'open-12', seed: 1 }, 6],
  [{ planner: 'a-star-drive', scene: 'patrol', seed: 1 }, 30],
  [{ planner: 'rrt-guided', scene: 'arm-cuboid', seed: 1 }, 60],
]

const at = ([setup, iteration]) => {
  const session = new Session(setup)
  session.seek(iteration)
  const told = { link: session.link(), hash: session.hash(), scene: session.scene }
  session.free()
  return told
}

const attribute = (name) => document.querySelector('[data-hash]')?.getAttribute(name) ?? null

const server = staticHost(DIST)
let site = ''
before(async () => {
  await new Promise((listening) => server.listen(0, '127.0.0.1', listening))
  site = `http://127.0.0.1:${server.address().port}/`
})
after(() => server.close())

// Chromium has the browser tests.
for (const [name, start] of Object.entries(ENGINES)) {
  describe(name, () => {
    let browser
    before(async () => {
      browser = await start()
    })
    after(() => browser?.close())

    /** Waits until a question to the page has this answer. */
    async function sees(expected, script, ...given) {
      const began = Date.now()
      let found
      do {
        // WebKit's driver fails while a page gives way to the next one: asked again, until there is no more patience.
        found = await browser.run(script, ...given).catch((error) => error)
        if (found === expected) return
        await new Promise((passed) => setTimeout(passed, 50))
      } while (Date.now() - began < PATIENCE)
      assert.equal(found, expected)
    }
    const shows = (hash) => sees(hash, attribute, 'data-hash')

    test('five runs have the hashes of the core', async () => {
      for (const run of RUNS) {
        const { link, hash } = at(run)
        await browser.open(`${site}?${run[0].planner}${link}`)
        await shows(hash)
      }
    })

    test('an arm is drawn in space', async () => {
      await sees('true', () => {
        const canvas = document.querySelector('[data-testid="stage"]')
        const words = document.querySelector('[data-testid="space-words"]')?.textContent ?? ''
        return String(words !== '' && canvas !== null && !canvas.hidden && document.querySelector('[data-testid="no-space"]') === null)
      })
    })

    test('a run plays, is stopped, and goes to any iteration', async () => {
      const [setup] = RUNS[0]
      await browser.open(`${site}?play${at([setup, 0]).link}`)
      await shows(at([setup, 0]).hash)
      const click = (id) => browser.run((testid) => document.querySelector(`[data-testid="${testid}"]`).click(), id)
      await click('play')
      await sees('true', () => String(Number(document.querySelector('[data-iteration]').dataset.iteration) > 5))
      await click('play')
      await sees('true', () => String(document.querySelector('[data-hash]').dataset.hash !== ''))
      await browser.run(() => {
        const timeline = document.querySelector('[data-testid="timeline"]')
        timeline.value = '33'
        timeline.dispatchEvent(new Event('input', { bubbles: true }))
      })
      await shows(at([setup, 33]).hash)
      await browser.run(() => document.querySelector('[data-testid="stage"]').focus())
      await browser.press('ArrowRight')
      await shows(at([setup, 34]).hash)
    })

    test('an obstacle is dragged, and the run is that of the edited scene', async () => {
      const [setup] = RUNS[0]
      await browser.open(`${site}?edit${at([setup, 10]).link}`)
      await shows(at([setup, 10]).hash)
      // The largest disc is in the middle of the stage's scene.
      const middle = await browser.run(() => {
        const { x, y, width, height } = document.querySelector('[data-testid="stage"]').getBoundingClientRect()
        return [x + width / 2, y + height / 2]
      })
      await browser.drag(middle, [middle[0] - 30, middle[1] + 20])
      await sees('true', () => String(!document.querySelector('[data-testid="undo"]').disabled))
      await browser.run(() => document.querySelector('[data-testid="undo"]').click())
      await browser.run(() => {
        const timeline = document.querySelector('[data-testid="timeline"]')
        timeline.value = '10'
        timeline.dispatchEvent(new Event('input', { bubbles: true }))
      })
      await shows(at([setup, 10]).hash)
    })

    test('the page in one file opens from a disk', async () => {
      const { link, hash } = at(RUNS[1])
      await browser.open(`${FILE}${link}`)
      await shows(hash)
    })
  })
}
