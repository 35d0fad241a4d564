import { readFile } from 'node:fs/promises'
import { expect, type Page, test } from '@playwright/test'
import type { UncheckedSetup } from 'forage-lab'
import type { DrawingOptions } from 'forage-lab/render'
import { hashOf, linkTo } from './support/core'
import { decoded, difference } from './support/pixels'
import { SITE } from './support/site'

/* The package's renderer draws a run as an embed of the page does. */

const PACKAGE = 'http://package.test/'
const TYPES: Readonly<Record<string, string>> = { js: 'text/javascript', wasm: 'application/wasm', json: 'application/json' }
const RUNS: readonly [setup: UncheckedSetup, iteration: number][] = [
  [{ planner: 'wcpso', scene: 'wcpso-discs', seed: 1 }, 5],
  [{ planner: 'ltqpso', scene: 'egg-crate', seed: 1 }, 4],
  [{ planner: 'aco', scene: 'rooms-20', seed: 1 }, 20],
  [{ planner: 'hybrid-bat', scene: 'random-52', seed: 1 }, 10],
  [{ planner: 'rrt-guided', scene: 'arm-cuboid', seed: 1 }, 60],
]
const SIZE = { width: 640, height: 400 }

interface Drawn {
  hash: string
  png: string
  svg: string
}

/** Draws a run on a page of somebody else. */
async function drawn(page: Page, setup: UncheckedSetup, iteration: number, options: DrawingOptions): Promise<Drawn> {
  await page.route(`${PACKAGE}**`, async (route) => {
    const file = new URL(route.request().url()).pathname.slice(1)
    if (file === '') return route.fulfill({ contentType: 'text/html', body: '<!doctype html><title>Course</title>' })
    const body = await readFile(new URL(`../../pkg/${file}`, import.meta.url)).catch(() => null)
    return body ? route.fulfill({ contentType: TYPES[file.split('.').at(-1) ?? ''] ?? '', body }) : route.fulfill({ status: 404 })
  })
  await page.goto(PACKAGE)
  return page.evaluate(
    async ([run, at, how]) => {
      const load = (file: string) => import(`/${file}`)
      const [{ default: init, ready, Session }, { drawOn }] = await Promise.all([load('forage.js'), load('render.js')])
      await init()
      const session = await ready(() => new Session(run))
      session.seek(at)
      const canvas = document.body.appendChild(document.createElement('canvas'))
      const drawing = drawOn(canvas, how)
      drawing.draw(session)
      const bytes = new Uint8Array(await (await drawing.png(1)).arrayBuffer())
      return {
        hash: session.hash(),
        png: btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join('')),
        svg: await drawing.svg('A run'),
      }
    },
    [setup, iteration, options] as const,
  )
}

for (const [setup, iteration] of RUNS) {
  test(`forage-lab/render draws ${setup.planner} as the page does`, async ({ page, context }) => {
    await page.setViewportSize(SIZE)
    await page.goto(`${SITE}?embed&controls=none${linkTo(setup, iteration)}`)
    const stage = page.getByTestId('stage')
    await expect(stage).toHaveAttribute('data-drawn')
    await expect(page.locator('[data-hash]').first()).toHaveAttribute('data-hash', hashOf(setup, iteration))
    const { width = 0, height = 0 } = (await stage.boundingBox()) ?? {}
    await page.evaluate(async () => {
      for (let frames = 0; frames < 20; frames += 1) await new Promise(requestAnimationFrame)
    })
    const shown = await stage.evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL())

    const { hash, png, svg } = await drawn(await context.newPage(), setup, iteration, { size: { width, height }, density: 1 })
    expect(hash).toBe(hashOf(setup, iteration))
    expect(svg).toContain('<title>A run</title>')
    expect(await difference(decoded(shown), decoded(png), 24)).toBeLessThan(0.004)
  })
}

test('it draws in the dark, without a layer and another part of the plane, on request', async ({ page, context }) => {
  const setup = { planner: 'wcpso', scene: 'wcpso-discs', seed: 1 }
  void page
  const pictures = []
  for (const options of [{}, { dark: true }, { layers: { particles: false } }, { camera: { center: [2, 2] as [number, number], zoom: 3 } }])
    pictures.push((await drawn(await context.newPage(), setup, 5, { size: SIZE, density: 1, ...options })).png)
  expect(new Set(pictures).size).toBe(pictures.length)
})

test('what cannot be drawn is refused by name', async ({ page }) => {
  const setup = { planner: 'wcpso', scene: 'wcpso-discs', seed: 1 }
  for (const [options, field] of [
    [{ density: 0 }, 'density'],
    [{ size: { width: NaN, height: 3 } }, 'size'],
    [{ camera: { center: [0, 0], zoom: -1 } }, 'camera'],
    [{ layers: { pheromone: true } }, 'layers'],
  ] as [DrawingOptions, string][])
    await expect(drawn(page, setup, 1, { size: SIZE, ...options })).rejects.toThrow(new RegExp(`${field}: .* is not allowed; it must be `))
})
