import type { Page } from '@playwright/test'
import { panels } from '../src/locales/en/panels'
import { hashOf, linkTo } from './support/core'
import { en, expect, test, pick } from './support/lab'

/* What takes long can be interrupted: a step between its parts, and a thread that does not answer is replaced. */

/** How many threads the page has started for its run. */
declare global {
  interface Window {
    threads?: number
  }
}

const threads = (page: Page): Promise<number | undefined> => page.evaluate(() => self.threads)

test.beforeEach(async ({ page }) => {
  await page.addInitScript(() => {
    const { Worker: Real } = window
    window.threads = 0
    window.Worker = class extends Real {
      constructor(url: string | URL, options?: WorkerOptions) {
        super(url, options)
        if (String(url).includes('run.worker')) window.threads = (window.threads ?? 0) + 1
      }
    }
  })
})

test('within a step that takes minutes a change takes effect, in the same thread @smoke', async ({ lab, page }) => {
  const endless = { planner: 'hybrid-bat', scene: 'random-280', seed: 1, params: { population: 4000, perturbations: 100_000 } }
  const short = { ...endless, params: { ...endless.params, perturbations: 3 } }
  await lab.open(linkTo(endless, 0))
  const start = await lab.settled(0)
  await page.getByTestId('step-forward').click()
  // Back where it was: the step that has begun is given up.
  await lab.timeline.fill('0')
  expect(await lab.settled(0)).toBe(start)
  // It says what it is at, and how to stop that.
  await page.getByTestId('step-forward').click()
  await expect(page.getByTestId('step-progress')).toContainText(en.transport.long('1'))
  await page.getByTestId('step-cancel').click()
  await expect(lab.button(en.transport.play)).toBeFocused()
  await expect(page.getByTestId('step-progress')).toBeHidden()
  expect(await lab.settled(0)).toBe(start)
  await lab.press(en.transport.play)
  const parameters = await lab.section('parameters')
  await parameters.locator('[data-parameter="perturbations"] input.typed').fill('3')
  await page.keyboard.press('Enter')
  await lab.restarted()
  expect(await lab.seek(1)).toBe(hashOf(short, 1))
  expect(await threads(page)).toBe(1)
})

test('a pause within a long step takes effect at its end', async ({ lab, page }) => {
  const long = { planner: 'sa', scene: 'random-280', seed: 1, params: { moves: 100_000 } }
  await lab.open(linkTo(long, 0))
  await lab.settled(0)
  await lab.press(en.transport.play)
  // It is within the step.
  await expect(page.getByTestId('step-progress')).toContainText(en.transport.long('1'))
  await lab.press(en.transport.pause)
  expect(await lab.settled(1)).toBe(hashOf(long, 1))
})

test('a thread that begins something too large is replaced when something else is wanted', async ({ lab, page }) => {
  const small = { planner: 'bat', scene: 'random-280', seed: 1, params: { population: 5 } }
  await lab.open(linkTo(small, 2))
  await lab.settled(2)
  const parameters = await lab.section('parameters')
  const population = parameters.locator('[data-parameter="population"] input.typed')
  const typed = async (value: string): Promise<void> => {
    await population.fill(value)
    await page.keyboard.press('Enter')
  }
  // To begin takes half a minute.
  await typed('50000')
  await expect(lab.root).toHaveAttribute('data-stale', 'true')
  await typed('7')
  await lab.restarted()
  await expect(page.getByTestId('crash')).toHaveCount(0)
  expect(await lab.seek(2)).toBe(hashOf({ ...small, params: { population: 7 } }, 2))
  expect(await threads(page)).toBe(2)
})

for (const [what, change, expected] of [
  ['a parameter that is reset', 'reset', {}],
  ['another planner', 'planner', { planner: 'sa' }],
] as const) {
  test(`a thread that begins something too large is replaced for ${what}`, async ({ lab, page }) => {
    const small = { planner: 'bat', scene: 'random-280', seed: 1 }
    await lab.open(linkTo(small, 0))
    await lab.settled(0)
    const parameters = await lab.section('parameters')
    const population = parameters.locator('[data-parameter="population"]')
    await population.locator('input.typed').fill('50000')
    await page.keyboard.press('Enter')
    await expect(lab.root).toHaveAttribute('data-stale', 'true')
    // The start has been sent, and keeps the thread.
    await expect(parameters.getByTestId('parameters')).toContainText(panels.parameters.changed(1))
    if (change === 'planner') await pick(page, 'planner', 'sa')
    else await parameters.getByRole('button', { name: panels.parameters.resetAll }).click()
    await lab.restarted()
    expect(await lab.seek(0)).toBe(hashOf({ ...small, ...expected, ...(change === 'planner' ? { params: {} } : {}) }, 0))
    expect(await threads(page)).toBe(2)
  })
}
