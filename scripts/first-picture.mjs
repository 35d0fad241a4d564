// Called by scripts/first-picture: opens the built page over an emulated fast 3G (1.6 Mbit/s, 150 ms) with gzip. The server is the
// slow line: one for the page and its workers alike, which the browser's own emulation is not.
import { readFileSync } from 'node:fs'
import { createServer } from 'node:http'
import { createRequire } from 'node:module'
import { extname, join, normalize } from 'node:path'
import { fileURLToPath } from 'node:url'
import { parseArgs } from 'node:util'
import { gzipSync } from 'node:zlib'
import { FLAGS } from '../www/tests/support/chromium.mjs'
import { TYPES } from '../www/tests/support/static.mjs'

const BYTES_PER_MS = 1.6e6 / 8 / 1000
const LATENCY_MS = 150
const BUDGET_MS = 2500
/** As much at once as a packet holds. */
const PACKET = 1400

const root = fileURLToPath(new URL('..', import.meta.url))
const dist = join(root, 'www/dist')
const require = createRequire(join(root, 'www/package.json'))
const { chromium } = require('playwright-core')
const { values } = parseArgs({ options: { times: { type: 'string', default: '5' }, language: { type: 'string', default: 'en' } } })
const times = Number(values.times)
if (!Number.isSafeInteger(times) || times < 1) {
  console.error(`--times is ${values.times}; it must be a whole number from 1.`)
  process.exit(2)
}

const wait = (ms) => new Promise((resolve) => setTimeout(resolve, ms))

/** What travels, in turns: all that is on its way shares the line. */
const line = []
let travelling = false
let answered = []

async function carry() {
  if (travelling) return
  travelling = true
  let due = performance.now()
  for (let one = line.shift(); one; one = line.shift()) {
    const packet = one.body.subarray(one.at, one.at + PACKET)
    due = Math.max(due, performance.now() - 20) + packet.length / BYTES_PER_MS
    if (due > performance.now()) await wait(due - performance.now())
    one.response.write(packet)
    one.at += packet.length
    if (one.at < one.body.length) line.push(one)
    else one.response.end()
  }
  travelling = false
}

const zipped = new Map()
const server = createServer(async (request, response) => {
  const asked = performance.now()
  const path = decodeURIComponent(new URL(request.url ?? '/', 'http://localhost').pathname)
  const file = join(dist, normalize(path === '/' ? 'index.html' : path))
  await wait(LATENCY_MS)
  try {
    if (!zipped.has(file)) zipped.set(file, gzipSync(readFileSync(file), { level: 9 }))
  } catch {
    response.writeHead(404).end()
    return
  }
  const body = zipped.get(file)
  answered.push({ path, asked, size: body.length })
  response.writeHead(200, { 'content-type': TYPES[extname(file)] ?? 'application/octet-stream', 'content-encoding': 'gzip' })
  line.push({ response, body, at: 0 })
  void carry()
})
await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve))

const browser = await chromium.launch({ executablePath: process.env.CHROMIUM, args: FLAGS })
const found = []
for (let k = 0; k < times; k++) {
  answered = []
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, locale: values.language })
  const page = await context.newPage()
  const began = performance.now()
  await page.goto(`http://127.0.0.1:${server.address().port}/`, { waitUntil: 'commit' })
  const mark = await page.waitForFunction(() => performance.getEntriesByName('first-picture')[0]?.startTime, undefined, { timeout: 60_000 })
  const ms = await mark.jsonValue()
  // When the navigation began here, give or take what the browser takes to begin it.
  found.push({ ms, loaded: answered.filter(({ asked }) => asked >= began && asked - began <= ms) })
  await context.close()
}
await browser.close()
server.closeAllConnections()
server.close()

found.sort((a, b) => a.ms - b.ms)
const { ms, loaded } = found[found.length >> 1]
for (const { path, size } of loaded) console.log(`${String(size).padStart(9)}  ${path}`)
console.log(`${String(loaded.reduce((sum, { size }) => sum + size, 0)).padStart(9)}  bytes with gzip`)
console.log(
  `first picture after ${found.map((one) => Math.round(one.ms)).join(', ')} ms; median ${Math.round(ms)} ms, budget ${BUDGET_MS} ms`,
)
process.exit(ms <= BUDGET_MS ? 0 : 1)
