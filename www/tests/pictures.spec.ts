import type { FunctionScene } from '../../pkg/node.js'
import { number } from '../src/text/number'
import { linkTo, particles, sceneOf, sessionAt } from './support/core'
import { expect, test } from './support/lab'

for (const scheme of ['light', 'dark'] as const) {
  test.describe(scheme, () => {
    test.use({ colorScheme: scheme })

    for (const scene of ['wcpso-discs', 'discs-slalom', 'discs-gate', 'ackley', 'egg-crate', 'rosenbrock']) {
      test(`${scene} is drawn, and each layer makes a difference`, async ({ lab }) => {
        await lab.open(linkTo({ scene }, 25))
        await lab.settled(25)
        const whole = await lab.picture()
        expect(whole.colours).toBeGreaterThan(200)
        expect(whole.width).toBeGreaterThan(600)
        const seen = new Set([whole.digest])
        for (const role of ['personal-bests', 'velocities', 'particles', 'best']) {
          const box = lab.page.getByTestId(`layer-${role}`)
          await box.setChecked(!(await box.isChecked()))
          // The thread that draws may be a few frames behind.
          const pictures = [whole.digest]
          await expect
            .poll(async () => {
              pictures.push((await lab.picture()).digest)
              return seen.has(pictures.at(-1) ?? '')
            })
            .toBe(false)
          seen.add(pictures.at(-1) ?? '')
        }
      })
    }
  })
}

test('on a function the height field is drawn under the particles', async ({ lab }) => {
  await lab.open(linkTo({ scene: 'rastrigin' }, 5))
  await lab.settled(5)
  for (const role of ['particles', 'best']) await lab.layer(role, false)
  // Without a field there would be the ground, the grid and its labels: a few shades.
  await expect.poll(async () => (await lab.picture()).colours).toBeGreaterThan(400)
})

test('a high-density screen gets its own pixels', async ({ browser }) => {
  const context = await browser.newContext({ viewport: { width: 1000, height: 700 }, deviceScaleFactor: 2 })
  const page = await context.newPage()
  const { Lab } = await import('./support/lab')
  const lab = new Lab(page)
  await lab.open(linkTo({}, 3))
  await lab.settled(3)
  const { width } = await lab.picture()
  expect(Math.abs(width - 2 * ((await lab.stage.boundingBox())?.width ?? 0))).toBeLessThan(2)
  await context.close()
})

test('a click on a particle explains its step with the numbers that were drawn', { tag: '@smoke' }, async ({ lab, page }) => {
  const setup = { scene: 'matyas' }
  await lab.open(linkTo(setup, 6))
  await lab.settled(6)
  const scene = sceneOf(setup) as FunctionScene
  // The particle farthest from all others: no doubt which one is meant.
  const all = particles(setup, 6)
  const alone = (p: readonly number[]): number =>
    Math.min(...all.filter((q) => q !== p).map((q) => Math.hypot(q[0] - (p[0] ?? 0), q[1] - (p[1] ?? 0))))
  const index = all.reduce((best, p, at) => (alone(p) > alone(all[best] ?? [0, 0]) ? at : best), 0)
  const at = await lab.whereIs(scene, all[index] ?? [0, 0])
  await page.mouse.click(at.x, at.y)

  const panel = page.getByTestId('inspect')
  await expect(panel.getByRole('heading', { level: 2 })).toHaveText(`Particle ${index}`)
  const told = sessionAt(setup, 6, (session) => session.inspect({ role: 'particles', index }))
  await expect(panel.locator('[data-event]')).toHaveAttribute('data-event', told?.event ?? '')
  for (const id of ['inspect-table', 'inspect-values']) await lab.section(id)
  for (const { name, value } of told?.values ?? []) {
    await expect(panel.locator(`[data-value="${name}"]`)).toHaveText(number(value))
  }
  for (const formula of told?.formulas ?? []) await expect(panel.getByTestId(`live-${formula}`)).not.toContainText('□')
  await expect(panel.locator('tbody tr')).toHaveCount(told?.table.rows.length ?? -1)
  // Every symbol is typeset: one that the build does not know would be there as TeX, in italics.
  expect(await panel.locator('.math math').count()).toBeGreaterThan(5)
  await expect(panel.locator('.math > i')).toHaveCount(0)

  await page.getByRole('button', { name: 'Close the inspection' }).click()
  await expect(panel.getByRole('heading', { level: 2 })).toHaveCount(0)
})

test('what the colours of a function stand for is in the legend; hidden, the heights are gone, and presented, they are there', async ({
  lab,
  page,
}) => {
  await lab.open(linkTo({ planner: 'pso', scene: 'rastrigin', seed: 1 }, 5))
  await lab.settled(5)
  const values = async (): Promise<number[]> => (await page.getByTestId('range-height').locator('span').allTextContents()).map(Number)
  await expect.poll(async () => (await values()).length).toBe(3)
  const [low = NaN, middle = NaN, high = NaN] = await values()
  expect(low).toBeGreaterThanOrEqual(0)
  expect(low).toBeLessThan(middle)
  expect(middle).toBeLessThan(high)
  const shown = await lab.wholePicture()
  await lab.layer('height', false)
  const bare = await lab.picture()
  expect(bare.colours).toBeLessThan(shown.colours / 4)
  await lab.layer('height', true)
  expect((await lab.picture()).digest).toBe(shown.digest)
  await page.keyboard.press('p')
  await expect(page.getByTestId('present-end')).toBeVisible()
  expect((await lab.picture()).colours).toBeGreaterThan(bare.colours)
})
