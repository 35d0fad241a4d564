import type { Page } from '@playwright/test'
import { budget, download, finished, keep, openBatch, seeds } from './support/batch'
import { expect, type Lab, test } from './support/lab'

/* A batch that outlives its page: its rows in the browser, its plan in the address. */

/** A small batch that has come to its end. */
async function small(lab: Lab): Promise<void> {
  await openBatch(lab)
  await keep(lab.page, ['wcpso', 'cpso'])
  await seeds(lab.page, 3)
  await budget(lab.page, 4650)
  await lab.page.getByTestId('batch-run').click()
  await finished(lab.page, 6)
}

const hashesIn = (page: Page): Promise<(string | undefined)[]> =>
  page.getByTestId('batch-row').evaluateAll((all) => all.map((one) => one.dataset.hash))

test('plan and results outlive a reload and go with the address, until they are deleted', async ({ lab, page, browser }) => {
  await small(lab)
  await expect(page.getByTestId('batch-kept')).toContainText('6')
  const hashes = await hashesIn(page)
  expect(hashes).toHaveLength(6)
  await expect(page).toHaveURL(/#view=compare&as=statistics&scene=wcpso-discs&seeds=1-3&budget=4650&with=cpso,wcpso$/)
  const address = page.url()
  await page.reload()
  await finished(page, 6)
  await expect.poll(() => hashesIn(page)).toEqual(hashes)
  expect(await page.getByTestId('entrant').evaluateAll((all) => all.map((one) => one.dataset.planner))).toEqual(['cpso', 'wcpso'])
  await expect(page.getByTestId('batch-budget')).toHaveValue('4650')

  // Somebody else has the plan by its address, and runs it.
  const elsewhere = await browser.newContext({ serviceWorkers: 'block' })
  const other = await elsewhere.newPage()
  await other.goto(address)
  await expect(other.getByTestId('batch-bar')).toHaveAttribute('data-total', '6')
  await expect(other.getByTestId('batch-bar')).toHaveAttribute('data-done', '0')
  await other.getByTestId('batch-run').click()
  await finished(other, 6)
  expect(await hashesIn(other)).toEqual(hashes)
  await elsewhere.close()

  await page.getByTestId('batch-delete').click()
  await expect(page.getByTestId('batch-bar')).toHaveAttribute('data-done', '0')
  await expect(page.getByTestId('batch-kept')).toHaveCount(0)
  await page.reload()
  await expect(page.getByTestId('batch-bar')).toHaveAttribute('data-total', '6')
  await expect(page.getByTestId('batch-bar')).toHaveAttribute('data-done', '0')
})

test('where a browser keeps nothing, results are dropped only when asked or saved', async ({ lab, page }) => {
  await page.addInitScript(() => {
    indexedDB.open = () => {
      throw new DOMException('not here', 'SecurityError')
    }
  })
  await small(lab)
  await expect(page.getByTestId('batch-kept')).toHaveCount(0)
  const asked = page.waitForEvent('dialog')
  void page.close({ runBeforeUnload: true })
  const dialog = await asked
  expect(dialog.type()).toBe('beforeunload')
  await dialog.dismiss()
  await download(page, 'csv')
  let again = 0
  page.on('dialog', (other) => {
    again += 1
    void other.accept()
  })
  await page.reload()
  await expect(page.getByTestId('entrant')).toHaveCount(2)
  expect(again).toBe(0)
  await expect(page.getByTestId('batch-bar')).toHaveAttribute('data-done', '0')
})

test('an address that makes no sense says so, and the view begins as without one', async ({ lab, page }) => {
  await lab.open('#view=batch&maps=nowhere;%=%&seeds=9-1&with=aco')
  await expect(page.getByTestId('compare-notice')).toContainText('nowhere')
  await expect(page.getByTestId('entrant')).toHaveCount(4)
})

test('a plan with random maps and parameters has an address; what cannot be read of one is said', async ({ lab, page }) => {
  await lab.open('#view=batch&maps=rooms;columns=20;rows=20&seeds=3-6&with=aco;alpha=2,dijkstra,nobody')
  await expect(page.getByTestId('compare-notice')).toContainText('nobody')
  await expect(page.getByTestId('entrant')).toHaveCount(2)
  await expect(page.getByTestId('batch-bar')).toHaveAttribute('data-total', '8')
  await expect(page).toHaveURL(/#view=compare&as=statistics&maps=rooms;columns=20;rows=20&seeds=3-6&budget=own&with=aco;alpha=2,dijkstra$/)
})
