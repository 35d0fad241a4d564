// Called by scripts/pictures: opens the built page in Chromium, steps a run and writes the pictures. The same page, Chromium
// and sharp give the same files.
import { existsSync } from 'node:fs'
import { mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises'
import { createRequire } from 'node:module'
import { tmpdir } from 'node:os'
import { join, resolve } from 'node:path'
import { fileURLToPath } from 'node:url'
import { FLAGS } from '../www/tests/support/chromium.mjs'
import { staticHost } from '../www/tests/support/static.mjs'

const root = fileURLToPath(new URL('..', import.meta.url))
const dist = resolve(root, process.argv[2] ?? 'www/dist')
const images = join(root, 'docs/images')
const require = createRequire(join(root, 'www/package.json'))
const { chromium } = require('playwright-core')
const sharp = require('sharp')

// A small swarm and a short run: one sees single particles, and how the swarm contracts.
const LINK = 'v=1&planner=wcpso&scene=wcpso-discs&seed=9&p.population=40&p.iterations=100'
// Every iteration while much happens, then fewer: about four seconds, and a pause at the end.
const ITERATIONS = [...range(0, 12, 1), ...range(12, 40, 2), ...range(40, 101, 4)]
const FRAME_MS = 80
const PAUSE_MS = 900
const STILL = 20
const WIDTH = 900
const LARGEST = 600_000

const DRAWING = [
  // Whole tiles at once and in order: otherwise icons differ in a few pixels from run to run.
  '--disable-partial-raster',
  '--num-raster-threads=1',
  '--force-color-profile=srgb',
]

function range(from, to, step) {
  return Array.from({ length: Math.ceil((to - from) / step) }, (_, k) => from + k * step)
}

/** Serves the built page on a free port; resolves to the server and its address. */
function serve() {
  const server = staticHost(dist)
  return new Promise((done) => server.listen(0, '127.0.0.1', () => done({ server, address: `http://127.0.0.1:${server.address().port}/` })))
}

/** Opens an iteration by its link. The page adds the state's hash to the address once it shows that state. */
async function show(page, address, iteration) {
  await page.goto(`${address}#${LINK}&at=${iteration}`)
  await page.waitForURL(new RegExp(`[#&]at=${iteration}&hash=[0-9a-f]{16}`))
  // Two frames: the stage is drawn in the first one after the address has changed.
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))))
}

/** A picture of the page, or of a part of it, once two in a row are the same. */
async function picture(page, clip) {
  const options = { clip, animations: 'disabled', caret: 'hide', scale: 'css' }
  let before = await page.screenshot(options)
  for (let k = 0; k < 20; k++) {
    const now = await page.screenshot(options)
    if (now.equals(before)) return now
    before = now
  }
  throw new Error('the page does not come to rest')
}

/** The moving picture in the best quality that is small enough. */
async function encoded(frames, delay) {
  for (const quality of [60, 50, 45, 40, 35, 30, 25, 20]) {
    const file = await sharp(frames, { join: { animated: true } })
      .webp({ quality, effort: 5, loop: 0, delay, minSize: true })
      .toBuffer()
    if (file.length <= LARGEST) return { file, quality }
  }
  throw new Error(`the moving picture has more than ${LARGEST} bytes`)
}

async function main() {
  if (!existsSync(join(dist, 'index.html'))) throw new Error(`${dist} has no page: run scripts/build-page`)
  await mkdir(images, { recursive: true })
  const profile = await mkdtemp(join(tmpdir(), 'forage-pictures-'))
  const { server, address } = await serve()
  const browser = await chromium.launchPersistentContext(profile, {
    executablePath: process.env.CHROMIUM ?? 'chromium',
    args: [...FLAGS, ...DRAWING],
    viewport: { width: 1440, height: 900 },
    deviceScaleFactor: 1,
    colorScheme: 'light',
    reducedMotion: 'reduce',
    locale: 'en-GB',
  })
  try {
    const page = browser.pages()[0] ?? (await browser.newPage())
    await show(page, address, STILL)
    const stage = page.getByTestId('stage')
    const box = await stage.boundingBox()
    if (!box) throw new Error('the page shows no stage')
    const clip = { x: Math.ceil(box.x), y: Math.ceil(box.y), width: Math.floor(box.width), height: Math.floor(box.height) }
    // The moving picture shows the scene, not the tools over it.
    const tools = (visibility) =>
      stage.evaluate((node, visibility) => {
        for (const button of node.parentElement.querySelectorAll('button')) button.style.visibility = visibility
      }, visibility)
    await tools('hidden')
    const frames = []
    for (const iteration of ITERATIONS) {
      await show(page, address, iteration)
      frames.push(
        await sharp(await picture(page, clip))
          .resize({ width: WIDTH })
          .png()
          .toBuffer(),
      )
    }
    await tools('')
    // The still comes last: browsers draw the first picture on a new canvas in slightly other shades.
    await show(page, address, STILL)
    const still = await sharp(await picture(page))
      .webp({ quality: 82, effort: 6 })
      .toFile(join(images, 'stage.webp'))
    console.log(`docs/images/stage.webp: ${still.width} × ${still.height}, ${still.size} bytes`)
    const delay = ITERATIONS.map((_, k) => (k + 1 === ITERATIONS.length ? PAUSE_MS : FRAME_MS))
    const { file, quality } = await encoded(frames, delay)
    await writeFile(join(images, 'wcpso.webp'), file)
    const seconds = delay.reduce((sum, ms) => sum + ms, 0) / 1000
    console.log(`docs/images/wcpso.webp: ${frames.length} frames, ${seconds} s, quality ${quality}, ${file.length} bytes`)
  } finally {
    await browser.close()
    server.close()
    await rm(profile, { recursive: true, force: true })
  }
}

await main()
