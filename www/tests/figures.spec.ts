import { readFile } from 'node:fs/promises'
import type { Page } from '@playwright/test'
import type { UncheckedSetup } from 'forage-lab'
import sharp from 'sharp'
import { batch } from '../src/locales/en/batch'
import { figures as text } from '../src/locales/en/figures'
import { panels } from '../src/locales/en/panels'
import { finished, keep, openBatch, seeds } from './support/batch'
import { linkTo } from './support/core'
import { en, expect, test } from './support/lab'

const SETUP: UncheckedSetup = { planner: 'wpso', scene: 'wcpso-discs', seed: 3 }

async function file(page: Page, testid: string): Promise<Buffer> {
  const [saved] = await Promise.all([page.waitForEvent('download'), page.getByTestId(testid).click()])
  return readFile(await saved.path())
}

const wordsIn = (svg: string): string =>
  [...svg.matchAll(/<text[^>]*>([^<]*)<\/text>/g)].map(([, words = '']) => words.replaceAll('&amp;', '&')).join('\n')

/** The pixel at the upper left corner. */
const corner = async (picture: Buffer): Promise<number[]> => [
  ...(await sharp(picture).extract({ left: 0, top: 0, width: 1, height: 1 }).removeAlpha().raw().toBuffer()),
]

test('the convergence chart is saved with titles on its axes, legend, caption and link, on a white ground for print', async ({
  lab,
  page,
}) => {
  await page.emulateMedia({ colorScheme: 'dark' })
  await lab.open(linkTo(SETUP, 40))
  await lab.settled(40)
  await lab.tab('chart')
  await page.getByTestId('figure-chart').click()
  const words = wordsIn(String(await file(page, 'figure-svg')))
  for (const word of [panels.chart.iteration, panels.chart.costs, panels.chart.exact, 'iteration 40', 'seed 3'])
    expect(words).toContain(word)
  expect(words.replaceAll('\n', '')).toContain(linkTo(SETUP, 40))

  const shown = await file(page, 'figure-png')
  await page.getByRole('radio', { name: text.print }).check({ force: true })
  await page.getByRole('radio', { name: '4×' }).check({ force: true })
  const printed = await file(page, 'figure-png')
  const [small, large] = [await sharp(shown).metadata(), await sharp(printed).metadata()]
  expect(large.width).toBe(4 * small.width)
  expect((await corner(shown)).every((channel) => channel < 64)).toBe(true)
  expect(await corner(printed)).toEqual([255, 255, 255])
})

test('the stage for print is white where the page is dark: what the core paints, too', async ({ lab, page }) => {
  await page.emulateMedia({ colorScheme: 'dark' })
  const shades = async (): Promise<number[]> => {
    const { channels } = await sharp(await file(page, 'export-png')).stats()
    return channels.slice(0, 3).map(({ mean }) => mean)
  }
  for (const setup of [
    { planner: 'pso', scene: 'rastrigin', seed: 1 },
    { planner: 'aco', scene: 'rooms-20', seed: 1 },
  ] as const) {
    await lab.open(linkTo(setup, 10))
    await lab.settled(10)
    await lab.press(en.bar.exports)
    await page.getByRole('radio', { name: text.asShown }).check({ force: true })
    const dark = await shades()
    await page.getByRole('radio', { name: text.print }).check({ force: true })
    const light = await shades()
    expect(Math.max(...dark)).toBeLessThan(100)
    expect(Math.min(...light)).toBeGreaterThan(140)
    await page.keyboard.press('Escape')
    await lab.settled(10)
  }
})

test('box plots and curves are saved with every run, their legend and how they were made', async ({ lab, page }) => {
  await openBatch(lab)
  await keep(page, ['pso', 'wpso'])
  await seeds(page, 8)
  await page.getByTestId('batch-run').click()
  await finished(page, 16)
  await page.getByTestId('figure-batch-boxes').click()
  const boxes = String(await file(page, 'figure-svg'))
  for (const word of [batch.results.gapAxis, 'PSO', 'WPSO', text.seeds('1', '8')]) expect(wordsIn(boxes)).toContain(word)
  // A run's dot is a circle of two halves; an outlier's is filled and has a rim.
  expect(new Set<string>(boxes.match(/<path d="M[^"]*A[^"]*A[^"]*"/g)).size).toBe(16)
  await page.keyboard.press('Escape')
  await page.getByTestId('figure-batch-bands').click()
  const bands = String(await file(page, 'figure-svg'))
  for (const word of [batch.results.evaluations, text.bands, 'WPSO']) expect(wordsIn(bands)).toContain(word)
  // Two bands, two medians.
  expect(bands.match(/fill-opacity/g)).toHaveLength(2)
})

/** The pictures of a GIF, and the pixels of one of them. */
async function gif(film: Buffer, at: number): Promise<{ pages: number; pixels: Buffer }> {
  const { pages = 1 } = await sharp(film).metadata()
  return { pages, pixels: await sharp(film, { page: at }).removeAlpha().raw().toBuffer() }
}

test('a range of iterations is recorded: the same range gives the same GIF, and the run stays where it was', { tag: '@smoke' }, async ({
  lab,
  page,
}) => {
  await lab.open(linkTo(SETUP, 40))
  const hash = await lab.settled(40)
  await lab.press(en.bar.exports)
  await page.getByRole('radio', { name: 'GIF' }).check({ force: true })
  await page.getByRole('radio', { name: '10/s' }).check({ force: true })
  await page.getByTestId('record-from').fill('10')
  await page.getByTestId('record-every').fill('7')
  await page.getByTestId('record-every').press('Enter')
  const film = await file(page, 'record')
  // 10, 17, 24, 31, 38 and 40; the last one stays for a while.
  const { pages, pixels } = await gif(film, 5)
  expect(pages).toBe(6 + 15)
  expect(film.equals(await file(page, 'record'))).toBe(true)

  // Its last picture is what the stage shows: but for the blends of its colours.
  await page.getByTestId('export-caption').uncheck()
  const { pixels: bare } = await gif(await file(page, 'record'), 5)
  const stage = await sharp(await file(page, 'export-png'))
    .removeAlpha()
    .toColourspace('srgb')
    .raw()
    .toBuffer()
  expect(pixels.length).toBeGreaterThan(bare.length)
  let off = 0
  for (let at = 0; at < stage.length; at += 1) if (Math.abs((stage[at] ?? 0) - (bare[at] ?? 0)) > 48) off += 1
  expect(off / stage.length).toBeLessThan(0.005)
  await page.keyboard.press('Escape')
  expect(await lab.settled(40)).toBe(hash)
})

test('videos are written where the browser can, a recording is cancelled, and a range that is none is refused', async ({ lab, page }) => {
  await lab.open(linkTo(SETUP, 30))
  await lab.settled(30)
  await lab.press(en.bar.exports)
  const webm = await file(page, 'record')
  expect(webm.subarray(0, 4)).toEqual(Buffer.from([0x1a, 0x45, 0xdf, 0xa3]))
  await page.getByRole('radio', { name: 'MP4' }).check({ force: true })
  expect((await file(page, 'record')).subarray(4, 8).toString()).toBe('ftyp')

  await page.getByTestId('record-to').fill('5000')
  await page.getByTestId('record-to').press('Enter')
  await expect(page.getByTestId('recording').getByRole('alert')).toContainText('5000')
  await expect(page.getByTestId('record')).toBeDisabled()
  await page.getByTestId('record-to').fill('500')
  await page.getByTestId('record-to').press('Enter')
  await page.getByTestId('record').click()
  await expect(page.getByRole('progressbar', { name: text.record.title })).toBeVisible()
  await page.getByTestId('record-cancel').click()
  await expect(page.getByTestId('record-told')).toHaveText(text.record.cancelled)
  await expect(page.getByTestId('record')).toBeEnabled()
})
