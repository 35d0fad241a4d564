// Called by scripts/trace: plays large runs in the built page and reads the browser's own trace.
import { createRequire } from 'node:module'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { parseArgs } from 'node:util'
import { generateScene, Session } from '../pkg/node.js'
import { FLAGS } from '../www/tests/support/chromium.mjs'
import { staticHost } from '../www/tests/support/static.mjs'

const BUSY_MS = 4
const ANSWER_MS = 100
/** The stage of a laptop. */
const VIEWPORT = { width: 1440, height: 900 }
/** A line that grows is measured once it is long. */
const TREE = 50_000

const open = { columns: 512, rows: 512, cell: 1, share: 0.2, stops: 0, moving: 0 }

/** What is played, from an iteration on; `pictures`: how many a second there must be. */
const CASES = {
  particles: { setup: { planner: 'pso', scene: 'sphere-2', params: { population: 100_000 } }, pictures: 30 },
  colony: { setup: { planner: 'aco', scene: generateScene('random', open, 1), params: { ants: 10 } }, pictures: 0 },
  tree: { setup: { planner: 'rrt-star', scene: 'wcpso-discs', params: { iterations: 6 * TREE } }, at: 1.2 * TREE, pictures: 0 },
}

const root = fileURLToPath(new URL('..', import.meta.url))
const { chromium } = createRequire(join(root, 'www/package.json'))('playwright-core')
const { values, positionals } = parseArgs({ options: { seconds: { type: 'string', default: '5' } }, allowPositionals: true })
const seconds = Number(values.seconds)
const unknown = positionals.find((name) => !(name in CASES))
if (unknown || !(seconds > 0)) {
  console.error(
    unknown ? `case ${unknown}: there are ${Object.keys(CASES).join(', ')}.` : `--seconds is ${values.seconds}; it must be more than 0.`,
  )
  process.exit(2)
}

const server = staticHost(join(root, 'www/dist'), '/')
await new Promise((listening) => server.listen(0, '127.0.0.1', listening))
const site = `http://127.0.0.1:${server.address().port}/`

const linkTo = ({ setup, at = 0 }) => {
  const session = new Session({ seed: 1, ...setup })
  session.seek(at)
  const link = session.link()
  session.free()
  return link
}

const quantile = (sorted, share) => sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] ?? NaN

/** Reads a trace: what the page's main thread computed and how long it was busy, in milliseconds, and when pictures were drawn. */
function read(trace, from, to) {
  const names = new Map(trace.filter(({ name }) => name === 'thread_name').map(({ pid, tid, args }) => [`${pid} ${tid}`, args.name]))
  const within = trace.filter(({ ts, dur = 0 }) => ts >= from && ts + dur <= to)
  const threadOf = ({ pid, tid }) => names.get(`${pid} ${tid}`) ?? ''
  const drawn = within.filter((event) => event.name === 'FireAnimationFrame' && threadOf(event).startsWith('DedicatedWorker'))
  const page = drawn[0]?.pid
  const tasks = within.filter((event) => event.name === 'RunTask' && event.pid === page && threadOf(event) === 'CrRendererMain')
  const times = drawn.map(({ ts }) => ts / 1000).sort((a, b) => a - b)
  const gaps = times
    .slice(1)
    .map((time, at) => time - times[at])
    .sort((a, b) => a - b)
  return {
    pictures: times.length,
    busy: tasks.reduce((sum, { dur = 0 }) => sum + dur, 0) / 1000,
    own: tasks.reduce((sum, { tdur = 0 }) => sum + tdur, 0) / 1000,
    drawing: quantile(
      drawn.map(({ dur = 0 }) => dur / 1000).sort((a, b) => a - b),
      0.5,
    ),
    longest: tasks.reduce((most, { dur = 0 }) => Math.max(most, dur), 0) / 1000,
    intervals: [0.5, 0.95, 1].map((share) => quantile(gaps, share)),
  }
}

async function measure(name, browser) {
  const context = await browser.newContext({ viewport: VIEWPORT })
  const page = await context.newPage()
  await page.goto(site + linkTo(CASES[name]))
  await page.locator('[data-testid=app][data-hash]:not([data-hash=""])').waitFor({ timeout: 120_000 })
  await page.getByTestId('speed').selectOption('Infinity')
  await page.getByTestId('play').click()
  await page.waitForTimeout(500)
  await browser.startTracing(page, {
    categories: ['devtools.timeline', 'disabled-by-default-devtools.timeline', 'toplevel', '__metadata'],
  })
  await page.evaluate(
    (ms) => new Promise((passed) => setTimeout(() => passed(console.timeStamp('end')), ms, console.timeStamp('begin'))),
    seconds * 1000,
  )
  const { traceEvents } = JSON.parse((await browser.stopTracing()).toString())
  const stamp = (message) => traceEvents.find((event) => event.name === 'TimeStamp' && event.args.data.message === message)?.ts
  const found = read(traceEvents, stamp('begin'), stamp('end'))
  found.answer = await answered(page, browser)
  await context.close()
  return found
}

/** What a key does is sent within so many microseconds after it was handled: at the end of the same task. */
const SAME_TASK = 2000

/**
 * The longest time from a key to what it does, in milliseconds: of keys that change the view, to the end of the first picture that the
 * thread that draws begins once it has the new view; of keys that pause it and go on, to the page's next picture on the screen.
 */
async function answered(page, browser) {
  await page.getByTestId('stage').focus()
  const press = async (keys) => {
    for (const key of keys) {
      await page.keyboard.press(key)
      await page.waitForTimeout(150)
    }
    await page.waitForTimeout(300)
  }
  await browser.startTracing(page, { categories: ['devtools.timeline', '__metadata'] })
  await press(['+', '-', '+', '0'])
  const { traceEvents } = JSON.parse((await browser.stopTracing()).toString())
  const names = new Map(traceEvents.filter(({ name }) => name === 'thread_name').map(({ pid, tid, args }) => [`${pid} ${tid}`, args.name]))
  const threadOf = ({ pid, tid }) => names.get(`${pid} ${tid}`) ?? ''
  const inOrder = traceEvents.sort((a, b) => a.ts - b.ts)
  const pictures = inOrder.filter((event) => event.name === 'FireAnimationFrame' && threadOf(event).startsWith('DedicatedWorker'))
  const arrived = (sent) =>
    inOrder.find(({ name, tid, args }) => name === 'HandlePostMessage' && tid === pictures[0]?.tid && sent.has(args.data?.traceId))
  const views = inOrder
    .filter(({ name, args }) => name === 'EventDispatch' && args.data?.type === 'keydown')
    .map(({ ts, dur = 0, tid }) => {
      const sent = inOrder.filter(
        (event) => event.name === 'SchedulePostMessage' && event.tid === tid && event.ts >= ts && event.ts <= ts + dur + SAME_TASK,
      )
      const view = arrived(new Set(sent.flatMap(({ args }) => args.data?.traceId ?? [])))
      const picture = view && pictures.find((event) => event.ts >= view.ts)
      return picture ? (picture.ts + (picture.dur ?? 0) - ts) / 1000 : Infinity
    })
  await page.evaluate(() => {
    window.answers = []
    new PerformanceObserver((list) => {
      for (const { name, duration } of list.getEntries()) if (name === 'keydown') window.answers.push(duration)
    }).observe({ type: 'event', durationThreshold: 16 })
  })
  await press([' ', ' ', ' ', ' '])
  return Math.max(...views, 16, ...(await page.evaluate(() => window.answers)))
}

const browser = await chromium.launch({ executablePath: process.env.CHROMIUM, args: FLAGS })
const card = await browser.newPage().then((page) =>
  page.evaluate(() => {
    const gl = document.createElement('canvas').getContext('webgl')
    const info = gl?.getExtension('WEBGL_debug_renderer_info')
    return info ? gl.getParameter(info.UNMASKED_RENDERER_WEBGL) : 'none'
  }),
)
console.log(`Chromium ${browser.version()}; drawn by ${card}; ${VIEWPORT.width} x ${VIEWPORT.height}, ${seconds} s each`)
console.log(
  'A picture: what the main thread computes for it, how long it is busy with it while other threads share the cores, and how long drawing takes.',
)
console.log(
  'case        pictures/s   intervals ms (50 %, 95 %, 100 %)   main: computes ms, busy ms, longest task   drawing ms   key answered ms',
)
let failed = false
for (const name of positionals.length > 0 ? positionals : Object.keys(CASES)) {
  const { pictures, intervals, own, busy, longest, drawing, answer } = await measure(name, browser)
  const each = own / Math.max(1, pictures)
  const row = [
    name.padEnd(10),
    (pictures / seconds).toFixed(1).padStart(12),
    intervals
      .map((ms) => ms.toFixed(0))
      .join(', ')
      .padStart(35),
    [each, busy / Math.max(1, pictures), longest]
      .map((ms) => ms.toFixed(1))
      .join(', ')
      .padStart(41),
    drawing.toFixed(1).padStart(13),
    answer.toFixed(0).padStart(18),
  ]
  console.log(row.join(''))
  const wrong = [
    pictures / seconds < CASES[name].pictures && `fewer than ${CASES[name].pictures} pictures a second`,
    each > BUSY_MS && `the main thread computes for more than ${BUSY_MS} ms a picture`,
    answer > ANSWER_MS && `a key is answered after more than ${ANSWER_MS} ms`,
  ].filter(Boolean)
  for (const what of wrong) console.error(`${name}: ${what}`)
  failed ||= wrong.length > 0
}
await browser.close()
server.close()
process.exit(failed ? 1 : 0)
