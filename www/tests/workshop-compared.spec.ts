import { seeds } from './support/batch'
import { expect, pick, test } from './support/lab'
import { CLIMBER, opened, behind, run } from './support/workshop'

test('many runs of a planner that was written here are compared; the address carries its code', async ({ lab, page }) => {
  await opened(page, CLIMBER)
  await run(page)
  await page.getByTestId('race-own').click()
  await expect(page.getByTestId('lane')).toHaveCount(2)
  await page.getByRole('radio', { name: 'Statistics' }).check()
  await seeds(page, 5)
  await page.getByTestId('batch-run').click()
  await expect(page.getByTestId('batch-summary').first()).toContainText('Hill climber')
  await expect(page.getByTestId('batch-summary').first()).toContainText('5')
  await expect(page).toHaveURL(/&codes=/)
  const address = new URL(page.url()).hash
  await page.reload()
  await expect(page.getByTestId('entrant').first()).toHaveAttribute('data-planner', 'my-hill-climber')
  // Elsewhere the code is shown first.
  await page.evaluate(() => {
    localStorage.clear()
    sessionStorage.removeItem('forage.comparison')
  })
  await page.goto('about:blank')
  await page.goto(`./${address}`)
  await expect(page.getByTestId('offer-code')).toContainText("name: 'my-hill-climber'")
  await page.getByTestId('offer-run').click()
  await expect(page.getByTestId('entrant').first()).toHaveAttribute('data-planner', 'my-hill-climber')
  await expect(page.getByTestId('batch-size')).toContainText('5 seeds')
  await lab.restarted()
})

test('runs of a comparison whose code does not end are ended, and it says so', async ({ page }) => {
  const endless = 'const all = Object.fromEntries(Array.from({ length: 1e5 }, (_, k) => [k, k])); for (;;) Object.keys(all)'
  await opened(
    page,
    CLIMBER.replace('const cost = evaluate(tried)', `const cost = evaluate(tried)\nif (tried.length === 4) { ${endless} }`),
  )
  await run(page)
  await page.getByTestId('race-own').click()
  await page.getByRole('radio', { name: 'Statistics' }).check()
  await pick(page, 'compare-scene', 'sphere-4')
  await seeds(page, 2)
  await page.getByTestId('batch-run').click()
  await expect(page.getByText('could not be stopped').first()).toBeVisible({ timeout: 30_000 })
})

test('a race has the newest code of a planner, and those that it is compared with stay', async ({ page }) => {
  await opened(page, CLIMBER)
  await run(page)
  await page.getByTestId('race-own').click()
  await expect(page.getByTestId('lane')).toHaveCount(2)
  // Those that it is compared with stay when its code is another one.
  await pick(page, 'compare-adds', 'wcpso')
  await expect(page.getByTestId('lane-best').first()).toHaveText(/\d/)
  await page.getByTestId('race-end').click()
  await expect(page.getByTestId('race')).toHaveAttribute('data-over', 'true')
  const slow = await page.getByTestId('lane-best').first().innerText()
  await page.getByTestId('view-workshop').click()
  await behind(page, '* normal()')
  await page.keyboard.type(' * 0.5')
  await expect(page.getByTestId('race-own')).toBeEnabled()
  await page.getByTestId('view-compare').click()
  await expect(page.getByTestId('lane')).toHaveCount(3)
  await expect(page.getByTestId('race')).toHaveAttribute('data-over', 'true')
  await expect(page.getByTestId('lane-best').first()).not.toHaveText(slow)
})
