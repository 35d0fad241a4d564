import { compare as plan } from '../src/locales/en/compare'
import { race as text } from '../src/locales/en/race'
import { exactly } from '../src/text/number'
import { catalogue } from '../../pkg/node.js'
import { violations } from './support/axe'
import { iterationsOf, linkTo, trialOf, verified } from './support/core'
import { expect, test, pick } from './support/lab'
import { finished, seeds } from './support/batch'
import { coreAt, Race } from './support/race'

const SWARMS = ['pso', 'wpso', 'cpso', 'wcpso']

const swarmsAt = (clock: number) => SWARMS.map((planner) => coreAt({ planner }, clock))

test.describe('without motion', () => {
  test.use({ contextOptions: { reducedMotion: 'reduce' } })

  test('four swarms stand at the first iteration at or beyond the clock, as the core does; going back gives the same', {
    tag: '@smoke',
  }, async ({ lab, page }) => {
    const race = new Race(page)
    await race.open(lab, 'swarms')
    // It does not play by itself.
    const first = await race.at(150)
    expect(first).toEqual(swarmsAt(150))
    await race.step('race-forward', 3)
    const third = await race.at(600)
    expect(third).toEqual(swarmsAt(600))
    // Between two steps of the planners.
    const between = await race.seek(10_001)
    expect(between).toEqual(swarmsAt(10_001))
    for (const { evaluations } of between) expect(evaluations).toBe(10_050)
    await race.step('race-back')
    expect(await race.at(9851)).toEqual(swarmsAt(9851))
    expect(await race.seek(600)).toEqual(third)
    await page.getByTestId('race-end').click()
    await expect(race.root).toHaveAttribute('data-over', 'true')
    expect(await race.at(75_150)).toEqual(swarmsAt(75_150))
    await page.getByTestId('race-restart').click()
    expect(await race.at(150)).toEqual(first)
  })

  test('who takes small steps and who takes large ones meet at the same evaluations; who is done stays at its end', async ({
    lab,
    page,
  }) => {
    const race = new Race(page)
    await race.open(lab, 'quantum')
    await pick(page, 'compare-scene', 'wcpso-discs')
    await race.still()
    await race.add('rrt-connect')
    await race.add('pso')
    await race.remove('ltqpso')
    await race.remove('qpso')
    // As many evaluations as the first takes.
    const budget = Number(await page.getByTestId('batch-budget').inputValue())
    const setups = ['rrt-connect', 'pso'].map((planner) => ({ planner, params: { iterations: iterationsOf({ planner }, budget) } }))
    const both = (clock: number) => setups.map((setup) => coreAt(setup, clock))
    expect(await race.seek(30)).toEqual(both(30))
    const later = await race.seek(400)
    expect(later).toEqual(both(400))
    expect(later[0]).toMatchObject({ status: 'solved', evaluations: 52 })
    expect(later[1]).toMatchObject({ status: 'running', evaluations: 450 })
    await expect(race.lanes.nth(0)).toContainText(text.lane.status.solved)
    // The tree has found a way, and the table says so, too.
    await expect(page.getByTestId('race-table').locator('tbody tr').first()).toHaveAttribute('data-planner', 'rrt-connect')
    await expect(race.lanes.nth(0).getByTestId('lane-rank')).toHaveText(text.lane.first(false, false))
    await expect(page.getByTestId('race-live')).toContainText('RRT-Connect')
  })

  test('a lane opens in the stage as exactly that run, and the race is found again as it was', async ({ lab, page }) => {
    const race = new Race(page)
    await race.open(lab, 'swarms')
    const before = await race.seek(6000)
    await race.lanes.nth(2).getByTestId('lane-open').click()
    expect(await lab.settled(before[2]?.iteration)).toBe(before[2]?.hash)
    await expect(page.getByTestId('planner')).toHaveAttribute('data-value', 'cpso')
    expect(verified(await lab.link(before[2]?.hash ?? ''))).toMatchObject({ planner: 'cpso', seed: 1, iteration: 39 })
    await page.getByTestId('view-compare').click()
    expect(await race.at(6000)).toEqual(before)
  })

  test('it takes up the stage’s scene, planner, parameters and seed', async ({ lab, page }) => {
    const race = new Race(page)
    await lab.open(linkTo({ planner: 'cpso', scene: 'discs-gate', seed: 9, params: { population: 40 } }, 5))
    await lab.settled(5)
    await page.getByTestId('view-compare').click()
    await expect(page.getByTestId('compare-scene')).toHaveAttribute('data-value', 'discs-gate')
    await expect(page.getByTestId('batch-from')).toHaveValue('9')
    await race.still()
    const [first] = await race.seek(2000)
    expect(first).toEqual(coreAt({ planner: 'cpso', scene: 'discs-gate', seed: 9, params: { population: 40 } }, 2000))
  })

  test('what is refused is said beside its control, and nothing is lost', { tag: '@smoke' }, async ({ lab, page }) => {
    const race = new Race(page)
    await race.open(lab, 'swarms')
    const before = await race.seek(3000)
    const seed = page.getByTestId('batch-from')
    await seed.fill('-4')
    await seed.press('Enter')
    await expect(page.getByText(plan.fields.whole(plan.plan.seed, '-4', '0', exactly(Number.MAX_SAFE_INTEGER - 1000)))).toBeVisible()
    await expect(seed).toHaveAttribute('aria-invalid', 'true')
    const notch = page.getByTestId('race-notch')
    await notch.fill('0.5')
    await notch.press('Enter')
    await expect(page.getByTestId('race-notch-error')).toHaveText(text.notchWrong('0.5'))
    await page.getByTestId('entrant-parameters').nth(0).click()
    const population = page.locator('[data-parameter="population"]')
    await population.getByRole('textbox').fill('0')
    await population.getByRole('textbox').press('Enter')
    await expect(population.getByRole('alert')).toContainText('population')
    await expect(population.getByRole('textbox')).toHaveValue('0')
    await page.keyboard.press('Escape')
    expect(await race.at(3000)).toEqual(before)

    // What is allowed counts, for that planner alone: it goes where the others are. All have its budget now: 40 + 500 × 40.
    await page.getByTestId('entrant-parameters').nth(1).click()
    await population.getByRole('textbox').fill('40')
    await population.getByRole('textbox').press('Enter')
    await expect(population.getByRole('alert')).toHaveCount(0)
    await page.keyboard.press('Escape')
    await expect(page.getByTestId('entrant').nth(1)).toContainText('population = 40')
    const iterations = Math.ceil((75_150 - 40) / 40)
    const changed = coreAt({ planner: 'wpso', params: { population: 40, iterations } }, 3000)
    // The run before stands at as many evaluations until the new one is there.
    await expect.poll(() => race.at(3000)).toEqual([before[0], changed, before[2], before[3]])
    await notch.fill('1000')
    await notch.press('Enter')
    await expect(page.getByTestId('race-notch-error')).toHaveCount(0)
    await race.step('race-forward')
    expect(await race.clock()).toBe(4000)
    await seed.fill('12')
    await seed.press('Enter')
    await expect(race.root).toHaveAttribute('data-clock', '40')
    expect((await race.seek(3000))[3]).toEqual(coreAt({ planner: 'wcpso', seed: 12 }, 3000))
  })

  test('a budget ends all of them, and the same budget in statistics ends in the same states', async ({ lab, page }) => {
    const race = new Race(page)
    await race.open(lab, 'swarms')
    await race.add('qpso')
    await page.getByTestId('batch-budget').fill('4000')
    await page.getByTestId('batch-budget').press('Enter')
    await page.getByTestId('race-end').click()
    await expect(race.root).toHaveAttribute('data-over', 'true')
    const ends = await race.at(4000)
    for (const { evaluations, planner } of ends) expect(evaluations, planner).toBeGreaterThanOrEqual(4000)
    await page.getByRole('radio', { name: plan.as.titles.statistics, exact: true }).check({ force: true })
    await seeds(page, 2)
    await page.getByTestId('batch-run').click()
    await finished(page, 10)
    for (const { planner, hash } of ends)
      await expect(page.locator(`[data-testid=batch-row][data-planner=${planner}][data-seed="1"]`)).toHaveAttribute('data-hash', hash)
  })

  test('another scene leaves out planners that do not run on it; where none does, others come', async ({ lab, page }) => {
    const race = new Race(page)
    await race.open(lab, 'trees')
    await pick(page, 'compare-scene', 'ant-bat-30')
    await race.still()
    await race.add('aco')
    await expect(race.lanes).toHaveCount(4)
    await pick(page, 'compare-scene', 'arm-cuboid')
    await race.still()
    await expect(page.getByTestId('entrant').filter({ hasText: /left out/ })).toHaveCount(1)
    await expect(race.lanes).toHaveCount(3)
    await pick(page, 'compare-scene', 'sphere')
    await expect(page.getByTestId('compare-notice')).toHaveText(plan.joined('Sphere, 10 variables'))
    await race.still()
    await expect(page.getByTestId('entrant').filter({ hasText: /left out/ })).toHaveCount(4)
    expect(await race.lanes.count()).toBeGreaterThan(1)
  })

  test('ways and tours don’t race each other', async ({ lab, page }) => {
    const race = new Race(page)
    await race.open(lab, 'ants')
    await page.getByRole('radio', { name: plan.plan.tasks.tour, exact: true }).check({ force: true })
    await race.still()
    const { planners } = catalogue()
    const titles = planners.filter(({ stops, kinds }) => stops && kinds.includes('grid')).map(({ title }) => title)
    await page.getByTestId('compare-adds').click()
    await expect(page.locator('.picker-list [data-option] > span')).toHaveText(titles)
    await page.keyboard.press('Escape')
    // No tour before all roads are built.
    await page.getByTestId('race-forward').click()
    await expect(race.root).toHaveAttribute('data-still', 'true', { timeout: 30_000 })
    await expect(race.lanes.first().getByTestId('lane-best')).toContainText('cells')
  })

  test('a tick that takes long can be called off: all stand where they were', async ({ lab, page }) => {
    const race = new Race(page)
    await race.open(lab, 'trees')
    await page.getByTestId('batch-budget').fill('200000')
    await page.getByTestId('batch-budget').press('Enter')
    await race.still()
    const before = await race.seek(40)
    await page.getByTestId('race-notch').fill('1000000')
    await page.getByTestId('race-notch').press('Enter')
    await page.getByTestId('race-play').click()
    await expect(page.getByText(text.lane.computing).first()).toBeVisible()
    await page.getByTestId('race-play').click()
    expect(await race.at(40)).toEqual(before)
    // What was found on the way is known, and the same.
    await page.getByTestId('race-notch').fill('100')
    await page.getByTestId('race-notch').press('Enter')
    await race.step('race-forward')
    expect(await race.at(140)).toEqual(
      ['rrt', 'rrt-connect', 'rrt-star'].map((planner) => coreAt({ planner, params: { iterations: 200_000 } }, 140)),
    )
  })

  test('everything goes with the keyboard alone', async ({ lab, page }) => {
    const race = new Race(page)
    await race.open(lab)
    await page.getByTestId('ready-swarms').focus()
    await page.keyboard.press('Enter')
    await race.at(150)
    const canvas = race.lanes.nth(1).getByTestId('lane-stage')
    for (let tabs = 0; tabs < 40 && !(await canvas.evaluate((node) => node === document.activeElement)); tabs += 1)
      await page.keyboard.press('Tab')
    await expect(canvas).toBeFocused()
    await page.keyboard.press('Shift+ArrowRight')
    expect(await race.at(1650)).toEqual(swarmsAt(1650))
    await page.keyboard.press('ArrowLeft')
    await race.at(1500)
    await page.keyboard.press('Space')
    await expect.poll(() => race.clock()).toBeGreaterThan(1800)
    await page.keyboard.press('Space')
    await race.still()
    await page.keyboard.press('Home')
    await race.at(150)
    await page.keyboard.press('End')
    await race.at(75_150)

    // What is typed into a field moves nothing.
    await page.getByTestId('batch-from').focus()
    await page.keyboard.press('Home')
    await page.keyboard.press('ArrowLeft')
    await page.keyboard.type(' ')
    await race.at(75_150)
    const chart = page.getByTestId('race-plot')
    await chart.focus()
    await page.keyboard.press('Home')
    await race.at(150)
    await page.keyboard.press('ArrowRight')
    expect(await race.at(300)).toEqual(swarmsAt(300))
    await expect(chart).toHaveAttribute('aria-valuetext', /^At 300 evaluations: PSO /)
  })

  test('all lanes are seen alike, and each has a picture of its own', async ({ lab, page }) => {
    const race = new Race(page)
    await race.open(lab, 'swarms')
    await race.seek(3000)
    const pictures = (): Promise<string[]> =>
      page.getByTestId('lane-stage').evaluateAll((all) => all.map((canvas) => (canvas as HTMLCanvasElement).toDataURL()))
    const whole = await pictures()
    expect(new Set(whole).size).toBe(4)
    await race.lanes.nth(0).getByTestId('lane-stage').focus()
    await page.keyboard.press('+')
    await expect.poll(async () => (await pictures()).filter((picture, at) => picture !== whole[at]).length).toBe(4)
    await page.keyboard.press('0')
    await expect.poll(pictures).toEqual(whole)
  })

  test('arms are seen from four sides, and drives drive', async ({ lab, page }) => {
    const race = new Race(page)
    await race.open(lab, 'arm')
    await race.seek(100)
    const picture = (): Promise<string> =>
      race.lanes
        .nth(1)
        .getByTestId('lane-stage')
        .evaluate((canvas) => (canvas as HTMLCanvasElement).toDataURL())
    const seen = new Set([await picture()])
    for (const side of ['front', 'side', 'top'] as const) {
      await page.getByRole('radio', { name: text.sides[side], exact: true }).check({ force: true })
      await expect.poll(async () => seen.has(await picture())).toBe(false)
      seen.add(await picture())
    }
    await race.choose('drives')
    await page.getByTestId('race-end').click()
    await expect(race.root).toHaveAttribute('data-over', 'true')
    const driven = ['wolf-ant-drive', 'a-star-drive', 'd-star-lite-drive'].map((planner) =>
      coreAt({ planner, scene: 'wolf-ant-20' }, Infinity),
    )
    expect(await race.standings()).toEqual(driven)
    for (const { status } of driven) expect(status).toBe('solved')
    // The drive takes no evaluations: it is one beyond the last that planning took.
    expect(await race.clock()).toBe(3001)
    expect(await race.seek(3000)).toEqual(
      ['wolf-ant-drive', 'a-star-drive', 'd-star-lite-drive'].map((planner) => coreAt({ planner, scene: 'wolf-ant-20' }, 3000)),
    )
    expect(await race.seek(3001)).toEqual(driven)
  })

  for (const colorScheme of ['light', 'dark'] as const) {
    for (const [screen, viewport] of Object.entries({ desktop: { width: 1440, height: 900 }, phone: { width: 390, height: 844 } })) {
      test.describe(`${screen}, ${colorScheme}`, () => {
        test.use({ colorScheme, viewport, hasTouch: screen === 'phone' })

        test('axe finds nothing wrong with a race, and nothing is too wide', {
          tag: screen === 'desktop' && colorScheme === 'light' ? ['@smoke'] : [],
        }, async ({ lab, page }) => {
          const race = new Race(page)
          await race.open(lab, 'swarms')
          await race.seek(3000)
          await page.getByTestId('batch-from').fill('x')
          await page.getByTestId('batch-from').press('Enter')
          await expect(page.getByTestId('batch-from')).toHaveAttribute('aria-invalid', 'true')
          expect(await violations(lab)).toEqual([])
          expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(viewport.width)
          await race.choose('arm')
          expect(await violations(lab)).toEqual([])
          await page.getByTestId('entrant-parameters').first().click()
          await expect(page.getByTestId('entrant-dialog')).toBeVisible()
          expect(await violations(lab)).toEqual([])
          expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(viewport.width)
        })
      })
    }
  }
})

test('a ready-made race begins by itself, stops when it is left, and is found again as it was', async ({ lab, page }) => {
  const race = new Race(page)
  await race.open(lab)
  await page.getByTestId('ready-swarms').click()
  await expect.poll(() => race.clock()).toBeGreaterThan(900)
  await page.getByTestId('view-lab').click()
  await expect(lab.stage).toBeVisible()
  await page.getByTestId('view-compare').click()
  const left = await race.standings()
  expect(left).toEqual(swarmsAt(await race.clock()))
  const speed = page.getByTestId('race-speed')
  await speed.selectOption('Infinity')
  await page.getByTestId('race-play').click()
  await expect(race.root).toHaveAttribute('data-over', 'true')
  expect(await race.at(75_150)).toEqual(swarmsAt(75_150))
})

test('racers with optima of their own say whose their gaps are', async ({ lab, page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  const race = new Race(page)
  await race.open(lab, 'exact')
  await page.getByTestId('race-end').click()
  await race.still()
  const by = ['dijkstra', 'a-star', 'theta-star'].map((planner) => trialOf({ planner, scene: 'ant-bat-30', seed: 1 }).record.exact_by)
  expect(new Set(by).size).toBe(2)
  for (const [at, reference] of by.entries()) {
    if (reference === 'refuted') throw new Error('no optimum')
    const told = text.lane.to(plan.references[reference])
    await expect(race.lanes.nth(at).getByTestId('lane-verdict')).toContainText(told)
    const planner = (await race.lanes.nth(at).getAttribute('data-planner')) ?? ''
    await expect(page.getByTestId('race-table').locator(`[data-planner=${planner}]`).getByTestId('race-gap')).toContainText(told)
  }
  await race.choose('swarms')
  await expect(page.getByTestId('race-gap').locator('small')).toHaveCount(0)
})

test('a racer whose engine stops says so, and begins again where the others are', async ({ lab, page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.addInitScript(() => {
    // The lab's, and after it those of the lanes.
    const made: Worker[] = []
    const { Worker: Real } = window
    window.Worker = class extends Real {
      constructor(url: string | URL, options?: WorkerOptions) {
        super(url, options)
        if (!/trial|render/.test(String(url))) made.push(this)
      }
    }
    Object.assign(window, { breakDown: () => made[2]?.dispatchEvent(new ErrorEvent('error', { message: 'unreachable' })) })
  })
  const race = new Race(page)
  await race.open(lab, 'quantum')
  await race.seek(600)
  await page.evaluate(() => (window as unknown as { breakDown(): void }).breakDown())
  // It is noticed as soon as it is asked for something.
  await page.getByTestId('race-forward').click()
  await expect(page.getByTestId('lane-crash')).toContainText('unreachable')
  await race.still()
  const clock = await race.clock()
  await page.getByRole('button', { name: text.lane.restart, exact: true }).click()
  await expect(page.getByTestId('lane-crash')).toHaveCount(0)
  expect(await race.at(clock)).toEqual(['qpso', 'ltqpso'].map((planner) => coreAt({ planner, scene: 'qpso-10m' }, clock)))
})

test.describe('a start that takes long', () => {
  test.use({ contextOptions: { reducedMotion: 'reduce' } })

  test('gives way to a newer parameter of the same racer', async ({ lab, page }) => {
    const race = new Race(page)
    await race.open(lab, 'tours')
    await pick(page, 'compare-scene', 'random-280')
    await race.still()
    await page.getByTestId('entrant-parameters').first().click()
    const population = page.locator('[data-parameter="population"]').getByRole('textbox')
    // To begin takes half a minute.
    await population.fill('50000')
    await population.press('Enter')
    await expect(page.getByTestId('entrant').first()).toContainText('population = 50000')
    await population.fill('7')
    await population.press('Enter')
    await expect(page.getByTestId('entrant').first()).toContainText('population = 7')
    await page.keyboard.press('Escape')
    await race.still()
    const setup = { planner: 'bat', scene: 'random-280', params: { population: 7 } }
    const iterations = iterationsOf(setup, 1_000_000)
    const [first] = await race.seek(3000)
    expect(first).toEqual(coreAt({ ...setup, params: { population: 7, iterations } }, 3000))
  })
})
