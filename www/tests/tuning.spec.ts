import type { Outcome, Session } from '../../pkg/node.js'
import { number } from '../src/text/number'
import { hashOf, linkTo, sessionAt, verified } from './support/core'
import { en, expect, type Lab, test, pick } from './support/lab'

/** Small enough for a test: four particles, two runs each. */
const PARAMS = { population: 4, seeds: 2, iterations: 5, colony_iterations: 15, tune: 'alpha,rho' }
const SETUP = { planner: 'pso-tuning', scene: 'wolf-ant-20', seed: 3, params: PARAMS }
/** One step takes long enough to be stopped. */
const LONG = { ...SETUP, params: { ...PARAMS, population: 40, seeds: 10, colony_iterations: 200 } }

/** As on a machine with so many cores: one of them isn't for runs. */
async function cores(lab: Lab, count: number): Promise<void> {
  await lab.page.addInitScript((n) => Object.defineProperty(navigator, 'hardwareConcurrency', { get: () => n }), count)
}

const tunedOf = (outcome: Outcome): NonNullable<Outcome['tuned']> => {
  if (!outcome.tuned) throw new Error('nothing was tuned')
  return outcome.tuned
}

for (const threads of [1, 4]) {
  test(`${threads} of threads beside: the same state as without them, played, sought, back and forth`, async ({ lab, page }) => {
    await cores(lab, threads)
    const workers = new Set<string>()
    let started = 0
    page.on('worker', (worker) => {
      // Another one draws.
      if (worker.url().includes('render.worker')) return
      workers.add(worker.url())
      started += 1
    })
    await lab.open(linkTo(SETUP, 3))
    expect(await lab.settled(3)).toBe(hashOf(SETUP, 3))
    // The thread of the run and those of its subtasks.
    expect(started).toBe(1 + threads)
    expect(workers.size).toBe(2)

    expect(await lab.seek(1)).toBe(hashOf(SETUP, 1))
    await page.getByTestId('step-forward').click()
    expect(await lab.settled(2)).toBe(hashOf(SETUP, 2))
    await page.getByTestId('speed').selectOption('Infinity')
    await lab.press(en.transport.play)
    expect(await lab.settled(5)).toBe(hashOf(SETUP, 5))
  })
}

const WITHOUT = {
  'can’t be': 'delete self.Worker;',
  'break down': `self.Worker = class extends EventTarget {
    constructor() { super(); setTimeout(() => this.onerror({ preventDefault() {}, message: 'none' })) }
    postMessage() {}
    terminate() {}
  };`,
}
for (const [what, script] of Object.entries(WITHOUT)) {
  test(`threads that ${what} leave the runs to the one that is there, which still can be stopped`, async ({ lab, page }) => {
    await page.route(/sim\.worker.*\.js$/, async (route) => {
      const response = await route.fetch()
      await route.fulfill({ response, body: script + (await response.text()) })
    })
    await lab.open(linkTo(SETUP, 2))
    expect(await lab.settled(2)).toBe(hashOf(SETUP, 2))
    await lab.open()
    await lab.open(linkTo(LONG, 0))
    const before = await lab.settled(0)
    await page.getByTestId('step-forward').click()
    await expect(page.getByTestId('step-progress')).toContainText(/[1-9]\d* of 400 runs/)
    await page.getByTestId('step-cancel').click()
    expect(await lab.settled(0)).toBe(before)
  })
}

test('how far a step is can be seen; stopped, it stands where it was and can go on', async ({ lab, page }) => {
  await lab.open(linkTo(LONG, 0))
  const before = await lab.settled(0)
  await page.getByTestId('step-forward').click()
  const progress = page.getByTestId('step-progress')
  await expect(progress).toContainText(/[1-9]\d* of 400 runs/)
  await expect(progress.getByRole('progressbar')).toBeVisible()
  await page.getByTestId('step-cancel').click()
  await expect(progress).toHaveCount(0)
  expect(await lab.settled(0)).toBe(before)

  // Playing is stopped by the pause as well, and another seed doesn't wait for the runs of this one.
  await lab.press(en.transport.play)
  await expect(progress).toBeVisible()
  await lab.press(en.transport.pause)
  expect(await lab.settled(0)).toBe(before)
  await lab.press(en.transport.play)
  await pick(page, 'planner', 'aco')
  await expect.poll(() => lab.iteration()).toBeGreaterThan(1)
  await expect(progress).toHaveCount(0)
})

test('what was tuned is told, and run at once; the tuner comes back with its own parameters', async ({ lab, page }) => {
  await lab.open(linkTo(SETUP, 5))
  await lab.settled(5)
  const { planner, params } = sessionAt(SETUP, 5, (session: Session) => tunedOf(session.outcome()))
  const card = page.getByTestId('tuned')
  for (const [name, value] of Object.entries(params)) {
    await expect(card.locator(`[data-tuned="${name}"]`)).toHaveText(number(Number(value)))
  }
  await page.getByTestId('use-tuned').click()
  await expect(page.getByTestId('planner')).toHaveAttribute('data-value', planner)
  const hash = await lab.seek(6)
  expect(hash).toBe(hashOf({ planner, scene: SETUP.scene, seed: 3, params }, 6))
  expect(verified(await lab.link(hash))).toMatchObject({ planner, params, seed: 3 })

  await pick(page, 'planner', 'pso-tuning')
  expect(await lab.seek(5)).toBe(hashOf(SETUP, 5))
})

test('several parameters are chosen by chips and by keys; one of them has to stay', { tag: '@smoke' }, async ({ lab, page }) => {
  await lab.open(linkTo(SETUP, 1))
  const one = await lab.settled(1)
  const row = (await lab.section('parameters')).locator('[data-parameter="tune"]')
  const chips = row.getByRole('group')
  await expect(chips).toHaveAccessibleName('Parameters to tune')
  await expect(chips.getByRole('checkbox', { checked: true })).toHaveCount(2)

  await chips.getByRole('checkbox', { name: 'β', exact: true }).focus()
  await page.keyboard.press('Space')
  await lab.restarted()
  const params = { ...PARAMS, tune: 'alpha,beta,rho' }
  expect(await lab.seek(1)).toBe(hashOf({ ...SETUP, params }, 1))

  for (const name of ['α', 'β']) await chips.getByRole('checkbox', { name, exact: true }).click()
  await expect(chips.getByRole('checkbox', { checked: true })).toHaveCount(1)
  const hash = await lab.seek(1)
  expect(hash).toBe(hashOf({ ...SETUP, params: { ...PARAMS, tune: 'rho' } }, 1))
  await chips.getByRole('checkbox', { name: 'ρ', exact: true }).click()
  await expect(row.getByRole('alert')).toContainText('tune')
  await expect(chips.getByRole('checkbox', { checked: true })).toHaveCount(0)
  expect(await lab.settled(1)).toBe(hash)

  await chips.getByRole('checkbox', { name: 'α', exact: true }).click()
  await expect(row.getByRole('alert')).toHaveCount(0)
  await chips.getByRole('checkbox', { name: 'ρ', exact: true }).click()
  await lab.restarted()
  expect(await lab.seek(1)).toBe(one)
})
