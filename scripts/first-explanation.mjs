// Called by scripts/first-explanation: does what a newcomer does, as fast as a script can.
import { createRequire } from 'node:module'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { parseArgs } from 'node:util'
import { FLAGS } from '../www/tests/support/chromium.mjs'
import { staticHost } from '../www/tests/support/static.mjs'

/** Pixels of a notch of the wheel. */
const NOTCH = 100
/** Milliseconds after which a click that hit nothing is followed by another. */
const PATIENCE = 150

const root = fileURLToPath(new URL('..', import.meta.url))
const { chromium } = createRequire(join(root, 'www/package.json'))('playwright-core')
const { values } = parseArgs({ options: { width: { type: 'string', default: '1366' }, height: { type: 'string', default: '768' } } })
const viewport = { width: Number(values.width), height: Number(values.height) }

const server = staticHost(join(root, 'www/dist'), '/')
await new Promise((listening) => server.listen(0, '127.0.0.1', listening))
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM, args: FLAGS })
const page = await browser.newPage({ viewport })

const began = performance.now()
const since = () => Math.round(performance.now() - began)
await page.goto(`http://127.0.0.1:${server.address().port}/`)
await page.waitForFunction(() => performance.getEntriesByName('first-picture').length > 0)
const picture = since()

// Some particle is beneath one of these points.
const box = await page.getByTestId('stage').boundingBox()
const sentence = page.getByTestId('learn-sentence')
let clicks = 0
for (; !(await sentence.isVisible()); clicks += 1) {
  const [column, row] = [0.35 + 0.02 * (clicks % 15), 0.45 + 0.1 * (Math.floor(clicks / 15) % 4)]
  await page.mouse.click(box.x + column * box.width, box.y + row * box.height)
  await page.waitForTimeout(PATIENCE)
}
const said = since()
await page.getByTestId('learn-why').click()

const formula = page.locator('[data-testid="inspect"] [data-testid^="live-"]').first()
await formula.waitFor()
const inView = async () => {
  const at = await formula.boundingBox()
  return at !== null && at.y >= 0 && at.y + at.height <= viewport.height
}
let notches = 0
for (; !(await inView()); notches += 1) {
  const column = await page.getByTestId('column').boundingBox()
  await page.mouse.move(column.x + column.width / 2, column.y + column.height / 2)
  await page.mouse.wheel(0, NOTCH)
  await page.waitForTimeout(PATIENCE)
}
console.log(
  `${viewport.width} × ${viewport.height}: first picture after ${picture} ms; a sentence after 1 click (${clicks - 1} before it hit no particle), ${said} ms; ` +
    `the formula in view after 2 clicks and ${notches} notches of the wheel, ${since()} ms`,
)
await browser.close()
server.close()
