import { catalogue } from '../../pkg/node.js'
import { closer } from '../src/locales/en/closer'
import { panels } from '../src/locales/en/panels'
import { number } from '../src/text/number'
import { hashOf, linkTo, sessionAt, verified } from './support/core'
import { en, expect, test, pick } from './support/lab'

test('a refused parameter says why beside it, keeps what was typed, and the run goes on', { tag: '@smoke' }, async ({ lab }) => {
  await lab.open(linkTo({}, 20))
  const hash = await lab.settled(20)
  const row = (await lab.section('parameters')).locator('[data-parameter="w_max"]')
  const field = row.getByLabel('Inertia weight at the start', { exact: true })

  for (const typed of ['abc', '7', '']) {
    await field.fill(typed)
    await field.press('Enter')
    await expect(row.getByRole('alert')).toContainText('w_max')
    await expect(field).toHaveValue(typed)
    await expect(field).toHaveAttribute('aria-invalid', 'true')
  }
  await expect(field).toHaveAccessibleDescription(/w_max/)
  expect(await lab.settled(20)).toBe(hash)

  await lab.press(en.transport.play)
  await expect.poll(() => lab.iteration()).toBeGreaterThan(22)
  await lab.press(en.transport.pause)
  expect(await lab.seek(20)).toBe(hash)
  await expect(field).toHaveValue('')
})

test('a parameter restarts the run, is in the link, and can be reset', async ({ lab }) => {
  await lab.open(linkTo({}, 20))
  await lab.settled(20)
  const row = (await lab.section('parameters')).locator('[data-parameter="w_max"]')
  const field = row.getByLabel('Inertia weight at the start', { exact: true })
  await field.fill('0.8')
  await field.press('Enter')
  await lab.restarted()
  const hash = await lab.settled(20)
  expect(hash).toBe(hashOf({ params: { w_max: 0.8 } }, 20))
  expect(verified(await lab.link(hash)).params).toEqual({ w_max: 0.8 })

  await row.getByRole('button', { name: 'Reset Inertia weight at the start to 0.95' }).click()
  await expect(field).toHaveValue('0.95')
  await lab.restarted()
  expect(await lab.settled(20)).toBe(hashOf({}, 20))
})

test('every parameter of every planner has a control with help, range and default', async ({ lab, page }) => {
  await lab.open(linkTo({}, 1))
  await lab.settled(1)
  const section = await lab.section('parameters')
  for (const planner of ['wcpso', 'pso', 'wpso', 'cpso', 'ltqpso', 'qpso']) {
    await pick(page, 'planner', planner)
    const { parameters } = sessionAt({ planner }, 0, (session) => ({ parameters: Object.keys(session.parameters) }))
    await expect(section.locator('[data-parameter]')).toHaveCount(parameters.length)
    for (const name of parameters) {
      const row = section.locator(`[data-parameter="${name}"]`)
      const about = row.locator('button[aria-expanded]')
      if ((await about.getAttribute('aria-expanded')) === 'false') await about.click()
      await expect(row.getByText(/Default: /)).toBeVisible()
    }
  }
})

test('the formulas hold the numbers of the iteration', async ({ lab, page }) => {
  await lab.open(linkTo({}, 120))
  await lab.settled(120)
  const { w, k } = sessionAt({}, 120, (session) => session.readings())
  await lab.section('readings')
  const readings = page.getByTestId('readings')
  await expect(readings.locator('[data-reading="w"]')).toHaveText(number(w))
  await expect(readings.locator('[data-reading="k"]')).toHaveText(number(k))
  await lab.section('formulas')
  const live = page.getByTestId('live-w')
  await expect(live).toContainText(`(${k})`)
  await expect(live).toContainText(`=${number(w)}`)
  await expect(live).not.toContainText('□')
})

const GRID = { planner: 'ltqpso', scene: 'qpso-10m' }

test('what hangs on another parameter is shown while that one has the value; a given value waits', async ({ lab }) => {
  await lab.open(linkTo(GRID, 3))
  await lab.settled(3)
  const section = await lab.section('parameters')
  const row = (name: string) => section.locator(`[data-parameter="${name}"]`)
  const choose = (name: string, value: string) => row(name).locator('select').selectOption(value)
  await expect(row('segments')).toBeVisible()
  for (const hidden of ['waypoints', 'initial_mean', 'initial_std', 'penalty']) await expect(row(hidden)).toHaveCount(0)

  await choose('initial', 'normal')
  const spread = row('initial_std').locator('input.typed')
  // A value that was taken can be reset; the run starts anew with it.
  const set = async (name: string, value: string): Promise<void> => {
    await row(name).locator('input.typed').fill(value)
    await row(name).locator('input.typed').press('Enter')
    await expect(row(name).locator('.reset')).toBeVisible()
    await lab.restarted()
  }
  await set('initial_std', '12')
  const normal = { initial: 'normal', initial_std: 12 }
  expect(await lab.seek(5)).toBe(hashOf({ ...GRID, params: normal }, 5))

  // The condition's own condition isn't met: both go, and the core isn't told of them.
  await choose('encoding', 'waypoints')
  for (const gone of ['initial', 'initial_std', 'segments']) await expect(row(gone)).toHaveCount(0)
  await expect(row('waypoints')).toBeVisible()
  await expect(lab.page.getByTestId('layer-guides')).toHaveCount(0)
  await set('waypoints', '4')
  expect(await lab.seek(5)).toBe(hashOf({ ...GRID, params: { encoding: 'waypoints', waypoints: 4 } }, 5))

  await choose('encoding', 'polar')
  await expect(spread).toHaveValue('12')
  await lab.restarted()
  expect(await lab.seek(5)).toBe(hashOf({ ...GRID, params: normal }, 5))
})

test('the paper’s sizes are offered, used at once, and told to be in use', async ({ lab, page }) => {
  await lab.open(linkTo(GRID, 3))
  await lab.settled(3)
  await lab.section('parameters')
  const offered = page.getByTestId('suggested')
  await expect(offered).toContainText('N = 16, M = 29')
  await offered.getByRole('button').click()
  await expect(lab.root).toHaveAttribute('data-limit', '29')
  await expect(offered).toContainText(panels.parameters.inUse)
  const hash = await lab.seek(29)
  expect(hash).toBe(hashOf({ ...GRID, params: { population: 16, iterations: 29 } }, 29))
  expect(verified(await lab.link(hash)).params).toEqual({ population: 16, iterations: 29 })

  await page.locator('[data-parameter="segments"] input.typed').fill('21')
  await page.locator('[data-parameter="segments"] input.typed').press('Enter')
  await expect(offered).toHaveCount(0)
})

test('a run that stops early doesn’t claim to have reached its limit; a path that cuts corners is below the optimum', async ({
  lab,
  page,
}) => {
  await lab.open(linkTo({ planner: 'ltqpso', scene: 'qpso-10m', params: { early_stop: 5 } }, 50))
  await lab.settled()
  const result = await lab.section('result')
  await expect(result.locator('[data-figure="state"]')).toHaveText(closer.result.early)

  await lab.open('#v=1&planner=pso&scene=wcpso-discs&seed=1&p.penalty=waypoints&at=500')
  await lab.settled(500)
  await expect(page.getByTestId('result-strip')).toContainText(en.result.below('', en.result.optimum.plain))
  await expect(page.getByTestId('result-strip')).not.toContainText(en.result.above('', en.result.optimum.plain))
})

test('a preset of a planner is a case: its values, its words, and the equations that hold under it', async ({ lab, page }) => {
  await lab.open(linkTo({}, 3))
  await lab.settled(3)
  await pick(page, 'case', 'cpso.fitted')
  const preset = catalogue()
    .planners.find(({ name }) => name === 'cpso')
    ?.presets.find(({ name }) => name === 'fitted')
  if (!preset) throw new Error('no preset')
  await lab.tab('explain')
  await expect(page.getByTestId('case-see')).toHaveText(preset.help)
  await lab.restarted()
  const link = verified(await lab.link(await lab.seek(7)))
  expect(link).toMatchObject({ planner: 'cpso', params: preset.params, iteration: 7 })
  expect(link.scene.name).toBe(preset.scene)
  await lab.section('formulas')
  await expect(page.getByTestId('live-w')).toBeVisible()

  await (await lab.section('parameters')).getByRole('button', { name: panels.parameters.resetAll }).click()
  await lab.section('formulas')
  await expect(page.getByTestId('formulas').locator('li').first()).toBeVisible()
  await expect(page.getByTestId('live-w')).toHaveCount(0)
})
