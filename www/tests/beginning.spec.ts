import { number } from '../src/text/number'
import { linkTo, outcomeOf } from './support/core'
import { en, expect, test } from './support/lab'
import { panels } from '../src/locales/en/panels'

test('before a tree has come to the goal, header and chart have its distance to it', async ({ lab, page }) => {
  await lab.open(linkTo({ planner: 'rrt', scene: 'wcpso-discs', seed: 1 }, 12))
  await lab.settled(12)
  await expect(page.getByTestId('before')).toHaveText([/^To the goal/, /^Nodes/])
  await expect(page.getByTestId('status')).toHaveText(en.result.none)
  const group = page.getByTestId('chart').getByRole('radio', { name: panels.chart.measures })
  await expect(group).toBeChecked()
  await expect(page.getByTestId('chart-empty')).toHaveCount(0)
  await page.getByTestId('chart').getByRole('radio', { name: panels.chart.costs }).check()
  await expect(page.getByTestId('chart-empty')).toHaveText(panels.chart.nothing)
})

test('where the result is smoothed the chart says what came of it: the number of the result', async ({ lab, page }) => {
  await lab.open(linkTo({ planner: 'ltqpso', scene: 'qpso-10m', seed: 1 }, 40))
  await lab.settled(40)
  await lab.tab('chart')
  const smoothed = page.getByTestId('chart').locator('.readout > div').filter({ hasText: panels.chart.smoothed })
  const { length } = outcomeOf({ planner: 'ltqpso', scene: 'qpso-10m', seed: 1 }, 40)
  for (const view of [panels.chart.costs, panels.chart.lengths]) {
    await page.getByTestId('chart').getByRole('radio', { name: view }).check({ force: true })
    await expect(smoothed.locator('dd')).toHaveText(number(length, 6))
  }
})
