import { hashOf, linkTo, verified } from './support/core'
import { en, expect, test } from './support/lab'

test('with the stage focused, keys do what the buttons do', { tag: '@smoke' }, async ({ lab, page }) => {
  await lab.open(linkTo({}, 30))
  await lab.settled(30)
  for (let tabs = 0; tabs < 30; tabs += 1) {
    await page.keyboard.press('Tab')
    if (await lab.stage.evaluate((stage) => stage === document.activeElement)) break
  }
  await expect(lab.stage).toBeFocused()

  await page.keyboard.press('Space')
  await expect.poll(() => lab.iteration()).toBeGreaterThan(33)
  await page.keyboard.press('Space')
  await lab.settled()
  await page.keyboard.press('Home')
  expect(await lab.settled(0)).toBe(hashOf({}, 0))
  await page.keyboard.press('Shift+ArrowRight')
  expect(await lab.settled(10)).toBe(hashOf({}, 10))
  await page.keyboard.press('ArrowLeft')
  expect(await lab.settled(9)).toBe(hashOf({}, 9))
  await page.keyboard.press('End')
  expect(await lab.settled(500)).toBe(hashOf({}, 500))
})

test('plus, minus and 0 zoom and show all again', async ({ lab, page }) => {
  await lab.open(linkTo({}, 30))
  await lab.settled(30)
  const whole = await lab.wholePicture()
  await lab.stage.focus()
  await page.keyboard.press('+')
  const near = await lab.picture()
  expect(near.digest).not.toBe(whole.digest)
  await page.keyboard.press('-')
  await page.keyboard.press('-')
  expect([near.digest, whole.digest]).not.toContain((await lab.picture()).digest)
  await page.keyboard.press('0')
  expect(await lab.picture()).toEqual(whole)
})

test('what is typed into a field moves nothing', async ({ lab, page }) => {
  await lab.open(linkTo({}, 30))
  const hash = await lab.settled(30)
  await page.getByTestId('seed').focus()
  await page.keyboard.press('Home')
  await page.keyboard.press('ArrowRight')
  await page.keyboard.type(' 0+')
  await page.keyboard.press('Delete')
  expect(await lab.settled(30)).toBe(hash)
})

test('the scene can be edited without a pointer', async ({ lab, page }) => {
  await lab.open(linkTo({}, 30))
  await lab.settled(30)
  // Tabs are chosen by arrows, as tabs are.
  await page.getByTestId('tab-chart').focus()
  await page.keyboard.press('ArrowRight')
  await expect(page.getByTestId('tab-setup')).toBeFocused()
  const section = page.getByTestId('section-scene')
  await section.locator('> summary').focus()
  await page.keyboard.press('Enter')
  const x = page.getByLabel(en.scene.field(en.scene.disc(1), en.scene.x), { exact: true })
  await x.focus()
  await page.keyboard.press('ControlOrMeta+a')
  await page.keyboard.type('4.5')
  await page.keyboard.press('Enter')
  await lab.restarted()

  // The object stays selected: arrows on the stage move it.
  await lab.stage.focus()
  await page.keyboard.press('ArrowUp')
  await expect(x).toHaveValue('4.5')
  const hash = await lab.seek(7)
  const { scene } = verified(await lab.link(hash))
  if (scene.kind !== 'discs') throw new Error(scene.kind)
  expect(scene.discs[0]?.center[0]).toBe(4.5)
  expect(scene.discs[0]?.center[1]).toBeGreaterThan(4.4750673)

  await page.keyboard.press('ControlOrMeta+z')
  await page.keyboard.press('ControlOrMeta+z')
  await lab.seek(30)
  expect(await lab.settled(30)).toBe(hashOf({}, 30))
})
