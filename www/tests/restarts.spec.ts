import type { UncheckedSetup } from '../../pkg/node.js'
import { hashOf, linkTo } from './support/core'
import { en, expect, test, pick } from './support/lab'

declare global {
  interface Window {
    delay?: number
  }
}

/* What is asked for while a run restarts: the thread's answers come late, its pictures at once. */

const SETUP = { planner: 'wcpso', scene: 'wcpso-discs', seed: 1 }
/** In milliseconds. */
const DELAY = 600

test.beforeEach(async ({ lab, page }) => {
  await page.addInitScript(() => {
    const listen = EventTarget.prototype.addEventListener
    Worker.prototype.addEventListener = function (type: string, listener: EventListenerOrEventListenerObject | null) {
      const late = (event: Event): void => {
        setTimeout(() => (typeof listener === 'function' ? listener.call(this, event) : listener?.handleEvent(event)), self.delay)
      }
      listen.call(this, type, late)
    }
  })
  await lab.open(linkTo(SETUP, 20))
  await lab.settled(20)
  await page.evaluate((delay) => {
    self.delay = delay
  }, DELAY)
})

const CHANGES: Record<string, { by: string; setup: Partial<UncheckedSetup> }> = {
  'a parameter': { by: 'parameter', setup: { params: { population: 12 } } },
  'the planner': { by: 'planner', setup: { planner: 'pso' } },
  'the seed': { by: 'seed', setup: { seed: 7 } },
}

for (const [what, { by, setup }] of Object.entries(CHANGES)) {
  test(`a seek right after a change of ${what} holds for the new run`, { tag: by === 'parameter' ? ['@smoke'] : [] }, async ({
    lab,
    page,
  }) => {
    const parameters = await lab.section('parameters')
    if (by === 'planner') await pick(page, 'planner', 'pso')
    if (by === 'seed') {
      await page.getByTestId('seed').fill('7')
      await page.keyboard.press('Enter')
    }
    if (by === 'parameter') {
      await parameters.locator('[data-parameter="population"] input.typed').fill('12')
      await page.keyboard.press('Enter')
    }
    await lab.timeline.fill('9')
    await lab.restarted()
    expect(await lab.settled(9)).toBe(hashOf({ ...SETUP, ...setup }, 9))
  })
}

test('steps and play right after a change hold for the new run', async ({ lab, page }) => {
  await pick(page, 'planner', 'pso')
  for (let step = 0; step < 3; step += 1) await page.getByTestId('step-forward').click()
  await lab.restarted()
  expect(await lab.settled(3)).toBe(hashOf({ ...SETUP, planner: 'pso' }, 3))

  await pick(page, 'planner', 'wcpso')
  await lab.press(en.transport.play)
  await lab.restarted()
  await expect(lab.root).toHaveAttribute('data-playing', 'true')
  await expect.poll(() => lab.iteration()).toBeGreaterThan(3)
})
