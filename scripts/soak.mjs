// Called by scripts/soak: uses the built page for long, and measures its memory.
import { readdirSync, readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { parseArgs } from 'node:util'
import { catalogue, Session } from '../pkg/node.js'
import { stream } from '../tests/fuzz.mjs'
import { FLAGS } from '../www/tests/support/chromium.mjs'
import { staticHost } from '../www/tests/support/static.mjs'

const WITHIN = 0.2
const VIEWPORT = { width: 1280, height: 800 }
/** Where memory is measured: the same run each time, at the same iteration. */
const BASE = { planner: 'wcpso', scene: 'wcpso-discs', seed: 1 }

const root = fileURLToPath(new URL('..', import.meta.url))
const { chromium } = createRequire(join(root, 'www/package.json'))('playwright-core')
const { values, positionals } = parseArgs({
  options: { minutes: { type: 'string', default: '30' }, seed: { type: 'string', default: '1' } },
  allowPositionals: true,
})
const { planners, scenes } = catalogue()
const minutes = Number(values.minutes)
const unknown = positionals.find((name) => !planners.some((planner) => planner.name === name))
if (unknown || !(minutes > 0)) {
  console.error(unknown ? `planner ${unknown}: there is none.` : `--minutes is ${values.minutes}; it must be more than 0.`)
  process.exit(2)
}
const { below, unit } = stream(Number(values.seed))

function linkOf(setup, at) {
  try {
    const session = new Session(setup)
    session.seek(at)
    const link = session.link()
    session.free()
    return link
  } catch {
    // This planner is for other scenes.
    return undefined
  }
}

/** The scenes of each planner; each round plays the next one of them. */
const links = planners
  .filter(({ name }) => positionals.length === 0 || positionals.includes(name))
  .map(({ name }) => ({ name, links: scenes.map((scene) => linkOf({ planner: name, scene: scene.name, seed: 1 }, 0)).filter(Boolean) }))

const server = staticHost(join(root, 'www/dist'), '/')
await new Promise((listening) => server.listen(0, '127.0.0.1', listening))
const site = `http://127.0.0.1:${server.address().port}/`
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM, args: FLAGS })
const page = await (await browser.newContext({ viewport: VIEWPORT })).newPage()
const errors = []
page.on('pageerror', (error) => errors.push(error.stack ?? String(error)))
page.on('crash', () => errors.push('the page crashed'))

// The page's threads, each with a memory of its own.
const devtools = await page.context().newCDPSession(page)
const threads = new Map()
let calls = 0
const answers = new Map()
devtools.on('Target.attachedToTarget', ({ sessionId, targetInfo }) => threads.set(sessionId, targetInfo))
devtools.on('Target.detachedFromTarget', ({ sessionId }) => threads.delete(sessionId))
devtools.on('Target.receivedMessageFromTarget', ({ message }) => {
  const { id, result } = JSON.parse(message)
  answers.get(id)?.(result)
  answers.delete(id)
})
await devtools.send('Target.setAutoAttach', { autoAttach: true, waitForDebuggerOnStart: false, flatten: false })
const inThread = (sessionId, method) =>
  new Promise((answered) => {
    calls += 1
    const id = calls
    answers.set(id, answered)
    // A thread that has ended meanwhile takes nothing.
    const ended = () => answers.delete(id) && answered({})
    setTimeout(ended, 10_000)
    devtools.send('Target.sendMessageToTarget', { sessionId, message: JSON.stringify({ id, method }) }).catch(ended)
  })

const heap = ({ usedSize = 0, embedderHeapUsedSize = 0, backingStorageSize = 0 }) => usedSize + embedderHeapUsedSize + backingStorageSize

/** What the processes take that this browser has for pages, in bytes. */
function resident() {
  const processes = new Map()
  for (const id of readdirSync('/proc').filter((name) => /^\d+$/.test(name))) {
    try {
      const [read, parent] = readFileSync(`/proc/${id}/stat`, 'utf8')
        .replace(/^.*\) /s, '')
        .split(' ')
      const isPage = readFileSync(`/proc/${id}/cmdline`, 'utf8').includes('--type=renderer')
      const pages = Number(readFileSync(`/proc/${id}/statm`, 'utf8').split(' ')[1])
      if (read) processes.set(Number(id), { parent: Number(parent), isPage, pages })
    } catch {
      // It has ended.
    }
  }
  const isOurs = (id) => id === process.pid || (processes.has(id) && isOurs(processes.get(id).parent))
  return [...processes].reduce((sum, [id, { isPage, pages }]) => sum + (isPage && isOurs(id) ? 4096 * pages : 0), 0)
}

/** What page and threads hold, each once nothing is left to collect. */
async function measure() {
  // What one thread lets go another one may have waited for.
  for (let k = 0; k < 2; k += 1) {
    await devtools.send('HeapProfiler.collectGarbage')
    for (const id of threads.keys()) await inThread(id, 'HeapProfiler.collectGarbage')
  }
  let held = heap(await devtools.send('Runtime.getHeapUsage'))
  for (const id of threads.keys()) held += heap(await inThread(id, 'Runtime.getHeapUsage'))
  return { held, resident: resident(), threads: threads.size }
}

async function open(link) {
  await page.evaluate((hash) => location.assign(hash), link)
  await page.locator('[data-testid=app][data-phase=ready][data-hash]:not([data-hash=""])').waitFor({ timeout: 60_000 })
}

const counts = { runs: 0, clicks: 0, seeks: 0, edits: 0, forks: 0, comparisons: 0 }
const scene = () => page.evaluate(() => new URLSearchParams(location.hash.slice(1)).get('scene'))
const found = async (id) => (await page.getByTestId(id).count()) > 0

/** A parameter of the run takes another value that is allowed; without one that can, nothing changes. */
async function change() {
  await page.getByTestId('tab-setup').click()
  const section = page.getByTestId('section-parameters')
  await section.waitFor()
  if (!(await section.evaluate((node) => node.open))) await section.locator('> summary').click()
  const inputs = section.locator('input[type=range]:visible')
  const count = await inputs.count()
  if (count === 0) return
  await inputs.nth(below(count)).evaluate((input, share) => {
    const { min, max, value } = input
    const [from, to] = [Number(min), Number(max)]
    input.value = String(from + share * (to - from))
    if (input.value === value) input.value = min
    for (const type of ['input', 'change']) input.dispatchEvent(new Event(type, { bubbles: true }))
  }, unit())
  await page.waitForTimeout(500)
}

/** Drags what it finds on the stage: the pointer tells what can be dragged. */
async function drag({ x, y, width, height }) {
  const { mouse } = page
  const before = await scene()
  for (let k = 0; k < 40; k += 1) {
    const at = [x + width * (0.15 + 0.7 * unit()), y + height * (0.15 + 0.6 * unit())]
    await mouse.move(...at)
    if ((await page.getByTestId('stage').evaluate((stage) => stage.style.cursor)) !== 'grab') continue
    await mouse.down()
    await mouse.move(at[0] + 40 * (unit() - 0.5), at[1] + 40 * (unit() - 0.5), { steps: 4 })
    await mouse.up()
    await page.waitForTimeout(500)
    if ((await scene()) !== before) counts.edits += 1
    return
  }
}

/** Plays a run, seeks, clicks on what is shown, which explains it, edits it, and compares it with what it was. */
async function use(link) {
  await open(link)
  await page.getByTestId('speed').selectOption('Infinity')
  await page.getByTestId('play').click()
  counts.runs += 1
  await page.waitForTimeout(1500)
  if ((await page.getByTestId('play').getAttribute('aria-label')) === 'Pause') await page.getByTestId('play').click()
  await page.getByTestId('timeline').evaluate((slider) => {
    slider.value = String(Math.ceil(Number(slider.max) / 2))
    slider.dispatchEvent(new Event('input', { bubbles: true }))
  })
  counts.seeks += 1
  const box = await page.getByTestId('stage').boundingBox()
  await page.getByTestId('tab-explain').click()
  for (let k = 0; k < 3; k += 1) await page.mouse.click(box.x + box.width * unit(), box.y + box.height * unit())
  counts.clicks += 3
  await drag(box)
  await change()
  if (!(await found('fork'))) return
  counts.forks += 1
  if (unit() < 0.3 && (await found('fork-compare'))) {
    await page.getByTestId('fork-compare').click()
    await page.waitForTimeout(1500)
    counts.comparisons += 1
    return
  }
  await page.getByTestId(unit() < 0.5 ? 'fork-undo' : 'fork-dismiss').click()
}

const megabytes = (bytes) => (bytes / 2 ** 20).toFixed(1).padStart(10)
const began = Date.now()
const elapsed = () => (Date.now() - began) / 60_000
const samples = []
console.log(`Chromium ${browser.version()}; ${links.length} planners, ${minutes} minutes, seed ${values.seed}`)
console.log('minute      runs   held MB  resident MB  threads')

/** The same run at the same iteration each time: what is held beyond it was left by what went before. */
async function sample() {
  await open(linkOf(BASE, 20))
  // What waits before it goes has gone.
  await page.waitForTimeout(3000)
  const found = { minute: elapsed(), runs: counts.runs, ...(await measure()) }
  samples.push(found)
  console.log(
    `${found.minute.toFixed(1).padStart(6)}${String(found.runs).padStart(10)}${megabytes(found.held)}${megabytes(found.resident)}   ${String(found.threads).padStart(7)}`,
  )
}

await page.goto(site + linkOf(BASE, 20))
await sample()
let last = elapsed()
for (let round = 0; elapsed() < minutes && errors.length === 0; round += 1) {
  for (const { name, links: own } of links) {
    if (elapsed() >= minutes || errors.length > 0) break
    try {
      await use(own[round % own.length])
    } catch (error) {
      errors.push(`${name}: ${error.message}`)
    }
    // A sample each two minutes, or ten in all.
    if (elapsed() - last >= Math.min(2, minutes / 10)) {
      await sample()
      last = elapsed()
    }
  }
}
await browser.close()
server.close()

const settle = Math.min(5, minutes / 3)
const [at, ...later] = samples.filter(({ minute }) => minute >= settle)
console.log(
  Object.entries(counts)
    .map(([what, count]) => `${count} ${what}`)
    .join(', '),
)
if (later.length > 0) {
  for (const what of ['held', 'resident']) {
    const shares = later.map((sample) => sample[what] / at[what])
    const [least, most] = [Math.min(...shares), Math.max(...shares)]
    console.log(`${what}: ${least.toFixed(2)} to ${most.toFixed(2)} of what it was after ${at.minute.toFixed(1)} minutes`)
    if (least < 1 - WITHIN || most > 1 + WITHIN) errors.push(`${what} memory left ±${100 * WITHIN} %`)
  }
}
if (later.length === 0) errors.push('there are too few samples to compare')
if (positionals.length === 0 && (counts.forks === 0 || counts.edits === 0)) errors.push('nothing was edited')
for (const error of errors) console.error(error)
process.exit(errors.length > 0 ? 1 : 0)
