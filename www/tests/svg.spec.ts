import { readFileSync } from 'node:fs'
import { readFile } from 'node:fs/promises'
import type { UncheckedSetup } from 'forage-lab'
import { catalogue } from '../../pkg/node.js'
import sharp from 'sharp'
import { linkTo } from './support/core'
import { decoded, difference } from './support/pixels'
import { en, expect, type Lab, test } from './support/lab'

/** Of each kind of picture one: areas, a height map, cells with a field, tubes with a hatch, numbers and arrows, a crowd of points. */
const RUNS: readonly [setup: UncheckedSetup, iteration: number][] = [
  [{ planner: 'wcpso', scene: 'wcpso-discs', seed: 1 }, 5],
  [{ planner: 'ltqpso', scene: 'egg-crate', seed: 1 }, 4],
  [{ planner: 'aco', scene: 'rooms-20', seed: 1 }, 20],
  [{ planner: 'a-star-drive', scene: 'patrol', seed: 1 }, 40],
  [{ planner: 'hybrid-bat', scene: 'random-52', seed: 1 }, 10],
  [{ planner: 'pso', scene: 'sphere-2', seed: 1, params: { population: 4000 } }, 2],
]
const LETTERS = `data:font/woff2;base64,${readFileSync('node_modules/@fontsource-variable/inter/files/inter-latin-wght-normal.woff2').toString('base64')}`
/** Channels that differ by more than this differ: edges are smoothed by two programs. */
const NOTICED = 40

async function drawing(lab: Lab): Promise<string> {
  await lab.press(en.bar.exports)
  const started = lab.page.waitForEvent('download')
  await lab.page.getByTestId('export-svg').click()
  const path = await (await started).path()
  await lab.page.keyboard.press('Escape')
  return readFile(path, 'utf8')
}

for (const [setup, iteration] of RUNS) {
  test(`the drawing of ${setup.planner} is what the stage shows`, async ({ lab, page, context }) => {
    await lab.open(linkTo(setup, iteration))
    await lab.settled(iteration)
    await lab.picture()
    const { width, height } = (await lab.stage.boundingBox()) ?? { width: 0, height: 0 }
    const canvas = await lab.stage.evaluate(
      (stage: HTMLCanvasElement) => new Promise<string>((resolve) => requestAnimationFrame(() => resolve(stage.toDataURL()))),
    )
    const svg = await drawing(lab)
    expect(svg).toContain(`<title>`)

    const viewer = await context.newPage()
    await viewer.setViewportSize({ width: Math.ceil(width), height: Math.ceil(height) })
    // It is set in the same letters.
    await viewer.setContent(
      `<style>@font-face{font-family:Inter;font-weight:100 900;src:url(${LETTERS})}</style><body style="margin:0">${svg}`,
    )
    await viewer.evaluate(() => document.fonts.load('600 12px Inter'))
    const seen = await viewer.screenshot({ clip: { x: 0, y: 0, width: Math.floor(width), height: Math.floor(height) } })
    await viewer.close()

    const region = { left: 0, top: 0, width: Math.floor(width), height: Math.floor(height) }
    expect(await difference(await sharp(decoded(canvas)).extract(region).toBuffer(), seen, NOTICED)).toBeLessThan(0.005)
    await page.bringToFront()
  })
}

test('the drawing of an arm is a parallel projection from where it is seen', async ({ lab, page }) => {
  await lab.open(linkTo({ planner: 'rrt-guided', scene: 'arm-cuboid', seed: 1 }, 300))
  await expect(lab.stage).toHaveAttribute('data-drawn')
  const corner = await drawing(lab)
  expect(corner.match(/<path/g)?.length).toBeGreaterThan(50)
  await page.getByTestId('view-top').click()
  await lab.picture()
  expect(await drawing(lab)).not.toBe(corner)
})

test('a figure has its caption, its legend and the run’s link, and as many pixels as asked for', async ({ lab, page }) => {
  const setup: UncheckedSetup = { planner: 'ltqpso', scene: 'qpso-10m', seed: 4 }
  await lab.open(linkTo(setup, 12))
  await lab.settled(12)
  const svg = await drawing(lab)
  const words = [...svg.matchAll(/<text[^>]*>([^<]*)<\/text>/g)].map(([, text = '']) => text.replaceAll('&amp;', '&')).join('\n')
  const { planners } = catalogue()
  expect(words).toContain(planners.find(({ name }) => name === 'ltqpso')?.title)
  for (const { title, on } of planners.find(({ name }) => name === 'ltqpso')?.layers ?? [])
    if (on && title !== 'Smoothed') expect(words).toContain(title)
  expect(words.replaceAll('\n', '')).toContain(linkTo(setup, 12))
  expect(words).toContain('seed 4')

  const box = await lab.stage.boundingBox()
  await lab.press(en.bar.exports)
  const picture = async (): Promise<{ width: number; height: number }> => {
    const started = page.waitForEvent('download')
    await page.getByTestId('export-png').click()
    return sharp(await (await started).path()).metadata()
  }
  await page.getByRole('radio', { name: '2×' }).check({ force: true })
  const captioned = await picture()
  expect(Math.abs(captioned.width - 2 * (box?.width ?? 0))).toBeLessThanOrEqual(2)
  expect(captioned.height).toBeGreaterThan(2 * (box?.height ?? 0) + 60)
  await page.getByTestId('export-caption').uncheck()
  const bare = await picture()
  expect(bare.width).toBe(captioned.width)
  expect(Math.abs(bare.height - 2 * (box?.height ?? 0))).toBeLessThanOrEqual(2)
})
