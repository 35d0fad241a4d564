import { generateScene } from '../../pkg/node.js'
import { allOf, moreIterations } from '../src/engine/budget'
import { batch as text } from '../src/locales/en/batch'
import { number } from '../src/text/number'
import { download, finished, openBatch } from './support/batch'
import { hashOf, iterationsOf, sessionAt, trialOf } from './support/core'
import { expect, test } from './support/lab'
import { Race } from './support/race'

/* What a batch spends, and what its values are measured by. */

test('a budget is spent where the first iteration misleads, as in the shell; what exceeds it is named', async ({ page, lab }) => {
  const ground = 'scene=random-52&seeds=1-2&budget=3000&with=hybrid-bat,bat'
  await lab.open(`#view=compare&as=statistics&${ground}`)
  await page.getByTestId('batch-run').click()
  await finished(page, 4)
  // The first iteration takes more evaluations than later ones: with as many as it lets expect, a third of the budget would be left.
  const rowsOf = (csv: string): Record<string, string>[] => {
    const [head = '', ...lines] = csv.trimEnd().split('\n')
    return lines.map((line) => Object.fromEntries(line.split(',').map((cell, at) => [head.split(',')[at] ?? '', cell])))
  }
  const rows = rowsOf(await download(page, 'csv'))
  const spent = rows.filter(({ planner }) => planner === 'hybrid-bat').map(({ evaluations }) => Number(evaluations))
  expect(spent.every((evaluations) => evaluations >= 3000 && evaluations < 3300)).toBe(true)
  // As many as the first iteration lets expect, and then more as the budget was not spent.
  const check = (row: Record<string, string>): void => {
    const setup = { planner: row.planner ?? '', scene: row.scene ?? '', seed: Number(row.seed) }
    const first = iterationsOf(setup, Number(row.budget))
    const over = sessionAt({ ...setup, params: { iterations: first } }, 1e6, ({ evaluations, iteration, limit }) => ({
      evaluations,
      iteration,
      limit,
    }))
    const more = moreIterations(over, first, Number(row.budget), 1e6) ?? NaN
    expect(Number(row.limit)).toBe(more + over.limit - first)
    expect(hashOf({ ...setup, params: { iterations: more } }, Number(row.iterations))).toBe(row.hash)
  }
  for (const row of rows.filter(({ planner }) => planner === 'hybrid-bat')) check(row)
  const most = Math.max(...rows.filter(({ planner }) => planner === 'bat').map(({ evaluations }) => Number(evaluations)))
  await expect(page.getByTestId('batch-overspent')).toContainText(text.results.upTo('Discrete bats', number(most)))
  await expect(page.getByTestId('batch-overspent')).not.toContainText('perturbation')
  // The shell chooses the iterations itself, by the same rule.
  expect(await download(page, 'toml')).toMatch(/budget = 3000\n\n\[\[planner]]\nname = "hybrid-bat"\n\n\[\[planner]]\nname = "bat"\n$/)

  // Roads are built before the first iteration: steps that are no iterations.
  await lab.open('#view=compare&as=statistics&scene=ant-bat-30&seeds=1-2&budget=400000&with=tour-pso')
  await page.getByTestId('batch-run').click()
  await finished(page, 2)
  for (const row of rowsOf(await download(page, 'csv'))) check(row)

  await lab.open(`#view=compare&as=watch&${ground}`)
  const race = new Race(page)
  await expect(race.root).toHaveAttribute('data-still', 'true')
  await race.timeline.focus()
  await race.timeline.press('End')
  await expect
    .poll(async () => (await race.standings()).find(({ planner }) => planner === 'hybrid-bat')?.evaluations, { timeout: 20_000 })
    .toBeGreaterThanOrEqual(3000)
})

test('instances of a function have other optima: runs are compared by how far above them they come', async ({ page, lab }) => {
  await openBatch(lab)
  await page.getByTestId('ready-bbob').click()
  // It begins by itself.
  await finished(page, 60)
  const setup = (seed: number) => ({ planner: 'qpso', scene: generateScene('bbob', { function: 'bbob-15', dimension: 10 }, seed), seed })
  const records = Array.from({ length: 15 }, (_, at) => at + 1).map((seed) => {
    const iterations = iterationsOf(setup(seed), 10_000)
    return trialOf({ ...setup(seed), params: { iterations } }).record
  })
  expect(new Set(records.map(({ exact }) => exact)).size).toBeGreaterThan(10)
  const above = records.map(({ cost, exact }) => (cost ?? NaN) - (exact ?? NaN)).sort((a, b) => a - b)
  const row = page.getByTestId('batch-summary').locator('tbody tr').nth(2)
  await expect(row).toContainText('QPSO')
  await expect(row).toContainText((above[7] ?? NaN).toString().slice(0, 4))
  // Files have what the core found, and what counts as near is a difference.
  const [head = '', ...lines] = (await download(page, 'csv')).trimEnd().split('\n')
  const at = (name: string): number => head.split(',').indexOf(name)
  const saved = lines.map((line) => line.split(',')).filter((cells) => cells[at('planner')] === 'qpso')
  const told = (cells: string[]) => ['value', 'exact', 'reached'].map((name) => cells[at(name)])
  expect(saved.map(told)).toEqual(
    records.map(({ value, exact, reached: after }) => [value, exact, after].map((cell) => String(cell ?? ''))),
  )
})

test('what a planner spends is asked again if that was called off', async ({ lab, page }) => {
  // Its first iteration takes a while: it is called off within it.
  await lab.open('#view=compare&as=statistics&scene=random-280&seeds=1-2&with=hybrid-bat,bat')
  await expect(page.getByTestId('entrant')).toHaveCount(2)
  await page.getByTestId('entrant-remove').first().click()
  await page.getByTestId('entrant-remove').first().click()
  await page.getByTestId('entrant-restore').click()
  await expect(page.getByTestId('entrant')).toHaveCount(1)
  await expect(page.locator('[data-testid=entrant][data-planner=bat]')).toBeVisible()
  const setup = { planner: 'bat', scene: 'random-280', seed: 1 }
  const [start, limit] = sessionAt(setup, 0, (session) => [session.evaluations, session.limit])
  const step = sessionAt(setup, 1, (session) => session.evaluations) - start
  await expect(page.getByTestId('batch-budget')).toHaveValue(String(allOf({ start, idle: 0, step, limit })), { timeout: 20_000 })
})
