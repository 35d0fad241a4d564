import { linkTo } from './support/core'
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
