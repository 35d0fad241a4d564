import { keys } from '../src/locales/en/keys'
import { violations } from './support/axe'
import { linkTo } from './support/core'
import { en, expect, test } from './support/lab'

test('Space plays wherever no field has the focus', async ({ lab, page }) => {
  await lab.open(linkTo({}, 0))
  await lab.settled(0)
  await expect(page.locator('body')).toBeFocused()
  await page.keyboard.press('Space')
  await expect.poll(() => lab.iteration()).toBeGreaterThan(0)
  await page.keyboard.press('Space')
  const at = await lab.iteration()
  await lab.settled()
  await page.getByTestId('seed').focus()
  await page.keyboard.press('Space')
  expect(await lab.iteration()).toBeGreaterThanOrEqual(at)
  await expect(page.getByRole('button', { name: en.transport.play, exact: true })).toBeVisible()
})

test('? shows all keys, everywhere but in a field', async ({ lab, page }) => {
  await lab.open(linkTo({}, 5))
  await lab.settled(5)
  const dialog = page.getByTestId('keys-dialog')
  for (const address of ['', '#view=race', '#view=papers']) {
    if (address) await page.evaluate((hash) => (location.hash = hash), address)
    await page.keyboard.press('?')
    await expect(dialog).toBeVisible()
    for (const { title } of keys.groups) await expect(dialog.getByRole('heading', { name: title, exact: true })).toBeVisible()
    if (!address) expect(await violations(lab)).toEqual([])
    await page.keyboard.press('Escape')
    await expect(dialog).toBeHidden()
  }
})
