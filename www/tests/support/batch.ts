import { readFile } from 'node:fs/promises'
import type { Page } from '@playwright/test'
import { number } from '../../src/text/number'
import { expect, type Lab } from './lab'

/* A batch as somebody sets it up. */

/** Opens the room; the plan then holds the four swarms. */
export async function openBatch(lab: Lab): Promise<void> {
  await lab.open('#view=compare&as=statistics')
  await expect(lab.page.getByTestId('entrant')).toHaveCount(4)
}

export async function keep(page: Page, planners: readonly string[]): Promise<void> {
  for (const planner of ['wcpso', 'pso', 'wpso', 'cpso']) {
    if (!planners.includes(planner))
      await page.locator(`[data-testid=entrant][data-planner=${planner}]`).getByTestId('entrant-remove').click()
  }
  await expect(page.getByTestId('entrant')).toHaveCount(planners.length)
}

export async function seeds(page: Page, count: number): Promise<void> {
  await page.getByTestId('batch-count').fill(String(count))
  await page.getByTestId('batch-count').press('Enter')
}

/** So many evaluations for all. */
export async function budget(page: Page, evaluations: number): Promise<void> {
  await page.getByTestId('batch-budget').fill(String(evaluations))
  await page.getByTestId('batch-budget').press('Enter')
}

export async function finished(page: Page, runs: number): Promise<void> {
  const bar = page.getByTestId('batch-bar')
  await expect(bar).toHaveAttribute('data-running', 'false', { timeout: 30_000 })
  await expect(bar).toHaveAttribute('data-done', String(runs))
  await expect(page.getByTestId('batch-runs').locator('caption')).toContainText(number(runs))
}

export async function download(page: Page, id: string): Promise<string> {
  const [saved] = await Promise.all([page.waitForEvent('download'), page.getByTestId(`batch-save-${id}`).click()])
  return readFile(await saved.path(), 'utf8')
}
