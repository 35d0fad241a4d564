import { compare, generateScene, reached, type TrialRecord } from '../../pkg/node.js'
import { batch as text } from '../src/locales/en/batch'
import { compare as plan } from '../src/locales/en/compare'
import { PADDING, ROW } from '../src/render/plot/statistics/layout'
import { digitsFor } from '../src/rooms/compare/statistics/words'
import { exactly, number, percent } from '../src/text/number'
import { violations } from './support/axe'
import { budget, download, finished, keep, openBatch, seeds } from './support/batch'
import { iterationsOf, trialOf } from './support/core'
import { en, expect, test, pick } from './support/lab'

const SCENE = 'wcpso-discs'

const recordsOf = (planners: readonly string[], count: number, params: Record<string, number> = {}): TrialRecord[][] =>
  planners.map((planner) => Array.from({ length: count }, (_, k) => trialOf({ planner, scene: SCENE, seed: k + 1, params }).record))

test('every run of a batch is the core’s own, whatever the number of workers, and so are the statistics', { tag: '@smoke' }, async ({
  lab,
  page,
}) => {
  await page.addInitScript(() => Object.defineProperty(navigator, 'hardwareConcurrency', { get: () => 5 }))
  await openBatch(lab)
  await keep(page, ['wcpso', 'pso'])
  await seeds(page, 6)
  await page.getByTestId('batch-run').click()
  await finished(page, 12)

  const groups = recordsOf(['wcpso', 'pso'], 6)
  for (const record of groups.flat()) {
    const row = page.locator(`[data-testid=batch-row][data-planner=${record.planner}][data-seed="${record.seed}"]`)
    await expect(row).toHaveAttribute('data-hash', record.hash)
  }

  const comparison = compare(groups.map((records) => ({ name: records[0]?.planner ?? '', values: records.map(({ value }) => value) })))
  const digits = digitsFor(comparison.groups.flatMap(({ summary }) => (summary ? [summary.min, summary.upper] : [])))
  for (const [at, label] of ['WCPSO', 'PSO'].entries()) {
    const summary = comparison.groups[at]?.summary
    if (!summary) throw new Error('no summary')
    const row = page.getByTestId('batch-summary').locator(`[data-planner=${label}]`)
    for (const told of [summary.mean, summary.interval?.[0], summary.min, summary.lower, summary.median, summary.upper, summary.max]) {
      await expect(row).toContainText(number(told, digits))
    }
    await expect(row).toContainText(number(summary.std))
    await expect(row.locator('td').last()).toHaveText(number(comparison.friedman?.ranks[at], 3))
  }
  // How surely and how soon they come near the optimum, and from when on mean ranks differ.
  const near = groups.map((records) =>
    reached(
      records.map((record) => record.reached),
      records.map((record) => record.evaluations),
    ),
  )
  const time = near[0]?.running_time
  if (!time) throw new Error('nobody came near')
  const cells = page.getByTestId('batch-summary').locator('[data-planner=WCPSO] td')
  await expect(cells.filter({ hasText: number(Math.round(time.expected)) })).toContainText(number(Math.round(time.interval?.[0] ?? NaN)))
  await expect(page.getByTestId('batch-results')).toContainText(
    text.summary.differFrom(number(comparison.friedman?.critical_difference ?? NaN, 3)),
  )
  const pair = comparison.pairs[0]
  if (!pair) throw new Error('no pair')
  await expect(page.getByTestId('batch-pairs').locator('tbody tr td').nth(1)).toHaveText(number(pair.p, 3))
  await expect(page.getByTestId('batch-pairs').locator('tbody tr td').nth(2)).toHaveText(number(pair.corrected, 3))
})

test('a batch that is stopped keeps its rows; it goes on to the same file that it would have come to', async ({ lab, page }) => {
  await openBatch(lab)
  await keep(page, ['pso', 'cpso'])
  await seeds(page, 40)
  const bar = page.getByTestId('batch-bar')
  await page.getByTestId('batch-run').click()
  await expect.poll(async () => Number(await bar.getAttribute('data-done'))).toBeGreaterThan(5)
  await page.getByTestId('batch-stop').click()
  await expect(bar).toHaveAttribute('data-running', 'false')
  const done = Number(await bar.getAttribute('data-done'))
  expect(done).toBeLessThan(80)
  await expect(page.getByTestId('batch-run')).toHaveText(text.run.goOn(String(80 - done)))

  // Rows outlive a change of the plan, and its way back.
  await seeds(page, 2)
  await expect(bar).toHaveAttribute('data-done', '4')
  await seeds(page, 40)
  await expect(bar).toHaveAttribute('data-done', String(done))

  // It goes on while something else is looked at.
  await page.getByTestId('batch-run').click()
  await page.getByTestId('view-lab').click()
  await expect(lab.stage).toBeVisible()
  await page.getByTestId('view-compare').click()
  await finished(page, 80)

  const [head = '', ...lines] = (await download(page, 'csv')).trimEnd().split('\n')
  expect(head).toBe(
    'scene,planner,seed,status,limit,iterations,budget,evaluations,cost,length,value,feasible,clearance,exact,exact_by,gap,within,reached,reached_iteration,settled,turns,deterministic,hash',
  )
  const allowance = Number(await page.getByTestId('batch-budget').inputValue())
  const records = recordsOf(['pso', 'cpso'], 40)
    .flat()
    .map((record) => ({ ...record, within: 0.01, budget: allowance }))
  const columns = head.split(',') as (keyof TrialRecord | 'within' | 'budget')[]
  const read = (text: string, like: unknown): unknown =>
    text === '' ? null : typeof like === 'number' ? Number(text) : typeof like === 'boolean' ? text === 'true' : text
  const told = lines.map((line, at) => line.split(',').map((cell, column) => read(cell, records[at]?.[columns[column] ?? 'hash'])))
  expect(told).toEqual(records.map((record) => columns.map((column) => record[column])))
  const objects = (await download(page, 'jsonl'))
    .trimEnd()
    .split('\n')
    .map((line) => JSON.parse(line) as TrialRecord)
  expect(objects).toEqual(records.map(({ parameters: _none, ...record }) => record))
})

test('the same planner takes part twice, with other parameters; the files name them', async ({ lab, page }) => {
  await openBatch(lab)
  await keep(page, ['pso'])
  await page.getByTestId('entrant-copy').click()
  await expect(page.getByTestId('entrant').nth(1)).toContainText(plan.entrants.double)

  await page.getByTestId('entrant-parameters').nth(1).click()
  const dialog = page.getByTestId('entrant-dialog')
  const inertia = dialog.locator('[data-parameter=w] input.typed')
  await inertia.fill('nonsense')
  await inertia.press('Enter')
  await expect(dialog.getByRole('alert')).toContainText('w')
  await expect(inertia, 'what was typed is kept').toHaveValue('nonsense')
  await inertia.fill('0.5')
  await inertia.press('Enter')
  await expect(dialog.getByRole('alert')).toHaveCount(0)
  await dialog.getByTestId('entrant-done').click()
  await expect(page.getByTestId('entrant').nth(1)).toContainText('w = 0.5')
  await budget(page, 6150)
  await seeds(page, 3)
  await page.getByTestId('batch-run').click()
  await finished(page, 6)

  const records = [recordsOf(['pso'], 3, { iterations: 40 }), recordsOf(['pso'], 3, { iterations: 40, w: 0.5 })].flat(2)
  const [head = '', ...lines] = (await download(page, 'csv')).trimEnd().split('\n')
  expect(head).toContain('scene,planner,seed,w,status,limit,iterations,budget,')
  expect(lines.map((line) => line.split(',').at(-1))).toEqual(records.map(({ hash }) => hash))
  expect(lines.map((line) => line.split(',').slice(3, 6).join())).toEqual([
    ...Array(3).fill(',exhausted,40'),
    ...Array(3).fill('0.5,exhausted,40'),
  ])
  const experiment = await download(page, 'toml')
  expect(experiment).toContain(`scenes = ["${SCENE}"]\nseeds = { from = 1, count = 3 }\nbudget = 6150\n`)
  expect(experiment).toContain('[[planner]]\nname = "pso"\n\n')
  expect(experiment).toContain('[[planner]]\nname = "pso"\nparams = { w = 0.5 }\n')
})

test('the outlier is found by sorting and opened on the stage; a dot opens its run, too', async ({ lab, page }) => {
  await openBatch(lab)
  await keep(page, ['pso'])
  await seeds(page, 8)
  await page.getByTestId('batch-run').click()
  await finished(page, 8)
  const records = recordsOf(['pso'], 8).flat()
  const worst = records.reduce((a, b) => ((a.value ?? Infinity) >= (b.value ?? Infinity) ? a : b))

  await page.getByTestId('sort-value').click()
  await page.getByTestId('sort-value').click()
  const first = page.getByTestId('batch-row').first()
  await expect(first).toHaveAttribute('data-seed', String(worst.seed))
  await first.getByRole('button').click()
  await expect(page.getByTestId('seed')).toHaveValue(String(worst.seed))
  await lab.restarted()
  expect(await lab.settled(worst.iterations)).toBe(worst.hash)
  await expect(page.getByTestId('planner')).toHaveAttribute('data-value', 'pso')
  await expect(page.getByTestId('notice')).toHaveCount(0)

  // Back, all is as it was, and the run that was looked at has the focus.
  await page.getByTestId('view-compare').click()
  await expect(page.getByTestId('batch-row').first().getByRole('button')).toBeFocused()

  const plot = page.getByTestId('batch-boxes')
  await plot.scrollIntoViewIfNeeded()
  const box = await plot.boundingBox()
  if (!box) throw new Error('no plot')
  const wanted = records[2]
  if (!wanted) throw new Error('no run')
  const y = box.y + PADDING.top + ROW.dots + ROW.dotsHeight * (((wanted.seed + 1) * 0.618033988749895) % 1)
  const tip = plot.getByText(new RegExp(`^${text.boxes.dot(exactly(wanted.seed), '')}`))
  for (let x = box.x; x < box.x + box.width && !(await tip.isVisible()); x += 5) await page.mouse.move(x, y)
  await expect(tip).toBeVisible()
  await page.mouse.down()
  await page.mouse.up()
  // The run of before had as many iterations: the stage stands at the same one.
  await expect(page.getByTestId('seed')).toHaveValue(String(wanted.seed))
  await lab.restarted()
  expect(await lab.settled(wanted.iterations)).toBe(wanted.hash)
})

test('the batch takes the planner as it is set up on the stage, and its edited scene goes with the experiment', async ({ lab, page }) => {
  await lab.open()
  await lab.section('scene')
  const x = page.getByLabel(en.scene.field(en.scene.disc(1), en.scene.x), { exact: true })
  await x.fill('4.5')
  await x.press('Enter')
  await lab.restarted()
  await page.getByTestId('view-compare').click()
  await page.getByRole('radio', { name: plan.as.titles.statistics, exact: true }).check({ force: true })
  await expect(page.getByTestId('compare-scene')).toHaveAttribute('data-value', ':stage')
  await keep(page, ['cpso'])
  await seeds(page, 2)
  await page.getByTestId('batch-run').click()
  await finished(page, 2)
  const files: string[] = []
  page.on('download', (saved) => void files.push(saved.suggestedFilename()))
  await page.getByTestId('batch-save-toml').click()
  await expect.poll(() => files.map((name) => name.split('.').at(-1)).sort()).toEqual(['json', 'toml'])
})

test('what is refused is told beside its field, and nothing that was typed is lost', { tag: '@smoke' }, async ({ lab, page }) => {
  await openBatch(lab)
  await page.getByTestId('batch-count').fill('1')
  await page.getByTestId('batch-count').press('Enter')
  const message = plan.fields.whole(plan.plan.count, '1', '2', exactly(1000))
  await expect(page.getByText(message)).toBeVisible()
  await page.getByTestId('batch-run').click()
  await expect(page.getByTestId('batch-count')).toBeFocused()
  await expect(page.getByText(text.run.faulty)).toBeVisible()
  await page.getByTestId('view-lab').click()
  await page.getByTestId('view-compare').click()
  await expect(page.getByTestId('batch-count')).toHaveValue('1')
  await expect(page.getByText(message)).toBeVisible()
  await seeds(page, 2)
  await expect(page.getByText(message)).toHaveCount(0)

  // Planners that don't run on another scene wait for their return.
  await pick(page, 'compare-scene', 'open-12')
  await expect(page.getByTestId('entrant').filter({ hasText: /left out/ })).toHaveCount(4)
  await expect(page.getByTestId('compare-notice')).toHaveText(plan.joined('12 stops, there and not back'))
  await pick(page, 'compare-scene', SCENE)
  await expect(page.getByTestId('batch-bar')).toHaveAttribute('data-total', '8')
})

test('runs without a feasible result are shown and counted, not left out', async ({ lab, page }) => {
  await openBatch(lab)
  await keep(page, [])
  await pick(page, 'compare-scene', SCENE)
  await pick(page, 'compare-adds', 'rrt')
  await budget(page, 600)
  await seeds(page, 12)
  await page.getByTestId('batch-run').click()
  await finished(page, 12)
  const records = recordsOf(['rrt'], 12, { iterations: 600 }).flat()
  const none = records.filter(({ feasible }) => !feasible).length
  expect(none).toBeGreaterThan(0)
  expect(none).toBeLessThan(12)
  await expect(page.getByTestId('batch-boxes')).toContainText(text.boxes.infeasibleCount(none))
  await page.getByTestId('sort-value').click()
  await expect(page.getByTestId('batch-row').last()).toContainText('–')
})

test('with the keyboard alone a batch is set up, run, sorted and looked into', async ({ lab, page }) => {
  await openBatch(lab)
  await keep(page, ['wcpso', 'cpso'])
  await page.getByTestId('batch-count').focus()
  await page.keyboard.press('ControlOrMeta+a')
  await page.keyboard.type('4')
  await page.keyboard.press('Tab')
  const run = page.getByTestId('batch-run')
  for (let tabs = 0; tabs < 40 && !(await run.evaluate((node) => node === document.activeElement)); tabs += 1)
    await page.keyboard.press('Shift+Tab')
  await page.keyboard.press('Enter')
  await finished(page, 8)
  await page.getByTestId('sort-evaluations').focus()
  await page.keyboard.press('Tab')
  await page.keyboard.press('Tab')
  await page.keyboard.press('Enter')
  await expect(page.getByTestId('sort-hash').locator('..')).toHaveAttribute('aria-sort', 'ascending')
  await page.keyboard.press('Tab')
  const hash = await page.getByTestId('batch-row').first().getAttribute('data-hash')
  await page.keyboard.press('Enter')
  expect(await lab.settled(500)).toBe(hash)
})

test('planners with optima of their own are compared by value, and what is deterministic isn’t tested', async ({ lab, page }) => {
  const scene = 'wolf-ant-20'
  const recordOf = (planner: string) => trialOf({ planner, scene, seed: 1 }).record
  const [cells, free] = [recordOf('a-star'), recordOf('theta-star')]
  expect(free.exact_by).not.toBe(cells.exact_by)
  expect([(free.value ?? 0) < (cells.value ?? 0), (free.gap ?? 0) > (cells.gap ?? 0)]).toEqual([true, true])

  await openBatch(lab)
  await keep(page, [])
  await pick(page, 'compare-scene', scene)
  for (const planner of ['a-star', 'theta-star']) {
    await pick(page, 'compare-adds', planner)
  }
  await seeds(page, 3)
  await page.getByTestId('batch-run').click()
  await finished(page, 6)
  await expect(page.getByTestId('batch-boxes')).toHaveAttribute('data-measure', 'value')
  const note = page.getByTestId('batch-references')
  const summary = page.getByTestId('batch-summary').locator('tbody tr')
  for (const [at, { exact_by: by }] of [cells, free].entries()) {
    if (by === 'refuted') throw new Error('no optimum')
    await expect(note).toContainText(plan.references[by])
    await expect(summary.nth(at)).toContainText(plan.references[by])
    await expect(summary.nth(at)).toContainText(text.summary.sure)
    // Neither spread nor interval, and no mean rank.
    await expect(summary.nth(at).locator('td').nth(3)).toHaveText('–')
  }
  await expect(page.getByTestId('batch-summary').getByRole('columnheader', { name: text.summary.rank, exact: true })).toHaveCount(0)
  const pair = page.getByTestId('batch-pairs').locator('tbody tr')
  await expect(pair.locator('td')).toHaveText([/./, '–', '–', '0 %', '–'])
  await expect(page.getByTestId('batch-verdicts').locator('li')).toHaveCount(1)

  // Beside one that does draw lots there is still nothing to test; two of them are corrected for their pair only.
  for (const planner of ['aco', 'aco-wolf']) {
    await pick(page, 'compare-adds', planner)
  }
  // As many evaluations as A* takes: 8 and 14 iterations of so many ants.
  await expect(page.getByTestId('batch-budget')).toHaveValue('400')
  const iterations: Readonly<Record<string, number>> = { aco: 8, 'aco-wolf': 14 }
  await page.getByTestId('batch-run').click()
  await finished(page, 12)
  const colonies = compare(
    ['aco', 'aco-wolf'].map((name) => ({
      name,
      values: [1, 2, 3].map((seed) => trialOf({ planner: name, scene, seed, params: { iterations: iterations[name] ?? 0 } }).record.value),
    })),
  )
  await expect(pair).toHaveCount(6)
  for (let at = 0; at < 5; at += 1) await expect(pair.nth(at).locator('td').nth(2)).toHaveText('–')
  await expect(pair.nth(5).locator('td').nth(1)).toHaveText(number(colonies.pairs[0]?.p, 3))
  await expect(pair.nth(5).locator('td').nth(2)).toHaveText(number(colonies.pairs[0]?.corrected, 3))
  const ranks = summary.locator('td:last-child')
  await expect(ranks).toHaveText(['–', '–', ...(colonies.friedman?.ranks ?? []).map((rank) => number(rank, 3))])
})

test('the charts over evaluations are read with the keyboard', async ({ lab, page }) => {
  await openBatch(lab)
  await keep(page, ['wcpso', 'cpso'])
  await seeds(page, 3)
  await budget(page, 4650)
  await page.getByTestId('batch-run').click()
  await finished(page, 6)
  for (const id of ['batch-bands', 'batch-reached']) {
    const chart = page.getByTestId(id)
    await chart.focus()
    const told = (name: string): Promise<string> => chart.getAttribute(`aria-value${name}`).then((value) => value ?? '')
    await page.keyboard.press('Home')
    expect(await told('now')).toBe(await told('min'))
    await page.keyboard.press('ArrowRight')
    expect(Number(await told('now'))).toBeGreaterThan(Number(await told('min')))
    // What is told aloud is what is seen beneath.
    expect(await told('text')).toMatch(/^[\d\s.,]+ evaluations, CPSO .+, WCPSO .+/)
    const legend = chart.locator('xpath=following-sibling::ul[1]').locator('.value')
    for (const value of await legend.allTextContents()) expect(await told('text')).toContain(value)
    await page.keyboard.press('End')
    expect(await told('now')).toBe(await told('max'))
    await page.keyboard.press('Escape')
    await expect(chart.locator('xpath=following-sibling::div[1]/p')).toHaveText(text.results.evaluations)
  }
})

test('long runs of a plan that was left make room for those of the new one', async ({ lab, page }) => {
  await page.addInitScript(() => Object.defineProperty(navigator, 'hardwareConcurrency', { get: () => 2 }))
  await openBatch(lab)
  await keep(page, ['pso'])
  await seeds(page, 2)
  await budget(page, 100_000_000)
  await page.getByTestId('batch-run').click()
  await expect(page.getByTestId('batch-stop')).toBeVisible()
  await budget(page, 3150)
  await finished(page, 2)
  const row = page.locator('[data-testid=batch-row][data-seed="2"]')
  await expect(row).toHaveAttribute('data-hash', recordsOf(['pso'], 2, { iterations: 20 })[0]?.[1]?.hash ?? '')
})

test('each seed has a random map of its own; runs are compared by their gaps, and open on their map', async ({ lab, page }) => {
  await openBatch(lab)
  await pick(page, 'compare-scene', ':maps rooms')
  await expect(page.getByText(plan.plan.mapsHelp)).toBeVisible()
  const removes = page.getByTestId('entrant-remove')
  for (let left = await removes.count(); left > 0; left -= 1) await removes.first().click()
  for (const name of ['aco-wolf', 'a-star']) {
    await pick(page, 'compare-adds', name)
  }
  await seeds(page, 4)
  await page.getByTestId('batch-run').click()
  await finished(page, 8)

  // A* may take as many evaluations as the ants, of which it needs a few.
  const budget = Number(await page.getByTestId('batch-budget').inputValue())
  const first = generateScene('rooms', {}, 1)
  const iterations = iterationsOf({ planner: 'a-star', scene: first, seed: 1 }, budget)
  const params: Readonly<Record<string, Record<string, number>>> = { 'a-star': { iterations } }
  const records = ['aco-wolf', 'a-star'].map((planner) =>
    [1, 2, 3, 4].map((seed) => trialOf({ planner, scene: generateScene('rooms', {}, seed), seed, params: params[planner] ?? {} }).record),
  )
  for (const { planner, seed, hash } of records.flat())
    await expect(page.locator(`[data-testid=batch-row][data-hash="${hash}"]`), `${planner}, map ${seed}`).toHaveCount(1)
  const [ants] = compare(records.map((of) => ({ name: of[0]?.planner ?? '', values: of.map(({ gap }) => gap) }))).groups
  const row = page.getByTestId('batch-summary').locator('tbody tr').first()
  await expect(row).toContainText(percent(ants?.summary?.mean ?? NaN))
  await expect(page.getByTestId('batch-summary')).toContainText(text.summary.captionMaps)
  // An experiment’s file names scenes, and has no such maps.
  await expect(page.getByTestId('batch-save-toml')).toHaveCount(0)

  const third = records[0]?.[2]
  await page.locator(`[data-testid=batch-row][data-hash="${third?.hash}"]`).getByRole('button').click()
  await expect(lab.stage).toBeVisible()
  expect(await lab.settled(third?.iterations ?? 0)).toBe(third?.hash)
})

test('leaving the page while a batch runs asks first', async ({ lab, page }) => {
  await openBatch(lab)
  await page.getByTestId('ready-swarms').click()
  const asked = page.waitForEvent('dialog')
  void page.close({ runBeforeUnload: true })
  const dialog = await asked
  expect(dialog.type()).toBe('beforeunload')
  await dialog.dismiss()
  await expect(page.getByTestId('batch-stop')).toBeVisible()
  await page.getByTestId('batch-stop').click()
  await expect(page.getByTestId('batch-run')).toBeVisible()
})

for (const scheme of ['light', 'dark'] as const) {
  test(`axe finds nothing wrong, ${scheme}`, { tag: scheme === 'light' ? ['@smoke'] : [] }, async ({ lab, page }) => {
    await page.emulateMedia({ colorScheme: scheme, reducedMotion: 'reduce' })
    await openBatch(lab)
    expect(await violations(lab)).toEqual([])
    await keep(page, ['wcpso', 'pso'])
    await seeds(page, 30)
    await page.getByTestId('batch-run').click()
    await finished(page, 60)
    expect(await violations(lab)).toEqual([])
    await page.getByTestId('entrant-parameters').first().click()
    await expect(page.getByTestId('entrant-dialog').getByTestId('parameters')).toBeVisible()
    expect(await violations(lab)).toEqual([])
  })
}

test('on a phone nothing is wider than the screen', { tag: '@smoke' }, async ({ lab, page }) => {
  await page.setViewportSize({ width: 390, height: 844 })
  await openBatch(lab)
  const wide = (): Promise<boolean> => page.evaluate(() => document.documentElement.scrollWidth > innerWidth)
  expect(await wide()).toBe(false)
  await keep(page, ['wcpso', 'pso'])
  await seeds(page, 2)
  await page.getByTestId('batch-run').click()
  await finished(page, 4)
  await expect(page.getByTestId('batch-bands').locator('canvas')).toBeVisible()
  expect(await wide()).toBe(false)
  const target = await page.getByTestId('batch-row').first().getByRole('button').boundingBox()
  expect(target?.height).toBeGreaterThanOrEqual(44)
})

test('a planner that was taken out is put back where it was', async ({ lab, page }) => {
  await openBatch(lab)
  const names = (): Promise<(string | null)[]> =>
    page.getByTestId('entrant').evaluateAll((all) => all.map((one) => one.getAttribute('data-planner')))
  const before = await names()
  await page.getByTestId('entrant-remove').nth(1).click()
  await expect(page.getByTestId('entrant')).toHaveCount(3)
  await page.getByTestId('entrant-restore').click()
  await expect(page.getByTestId('entrant')).toHaveCount(4)
  expect(await names()).toEqual(before)
  await expect(page.getByTestId('entrant-restore')).toHaveCount(0)
})
