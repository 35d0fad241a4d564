import { panels } from '../src/locales/en/panels'
import { hashOf, linkTo, verified } from './support/core'
import { en, expect, test } from './support/lab'

test('a step forward and a step back lead to the identical frame', { tag: '@smoke' }, async ({ lab }) => {
  await lab.open(linkTo({}, 40))
  const hash = await lab.settled(40)
  const picture = await lab.wholePicture()

  await lab.press(en.transport.forward)
  expect(await lab.settled(41)).toBe(hashOf({}, 41))
  expect((await lab.picture()).digest).not.toBe(picture.digest)

  await lab.press(en.transport.back)
  expect(await lab.settled(40)).toBe(hash)
  expect(await lab.picture()).toEqual(picture)
})

test('the timeline shows any iteration, past or future, exactly', { tag: '@smoke' }, async ({ lab }) => {
  await lab.open(linkTo({}, 10))
  for (const iteration of [300, 17, 0, 500, 299]) expect(await lab.seek(iteration)).toBe(hashOf({}, iteration))
})

test('a newer jump overtakes an older one', async ({ lab }) => {
  const params = { population: 3000 }
  await lab.open(linkTo({ params }, 2))
  await lab.settled(2)
  await lab.timeline.fill('500')
  await lab.timeline.fill('3')
  expect(await lab.settled(3)).toBe(hashOf({ params }, 3))
})

test('restart leads to iteration 0 and a new seed to another run', async ({ lab, page }) => {
  await lab.open(linkTo({}, 25))
  await lab.settled(25)
  await lab.press(en.transport.restart)
  const first = await lab.settled(0)
  expect(first).toBe(hashOf({}, 0))
  await lab.press(en.transport.newSeed)
  await expect(lab.root).not.toHaveAttribute('data-hash', first)
  const hash = await lab.seek(1)
  const { seed } = verified(await lab.link(hash))
  expect(seed).not.toBe(1)
  await expect(page.getByTestId('seed')).toHaveValue(String(seed))
})

test('a click in the chart, and its keys, jump to that iteration', async ({ lab, page }) => {
  await lab.open(linkTo({}, 200))
  await lab.settled(200)
  const plot = page.getByRole('slider', { name: panels.chart.label })
  await plot.focus()
  await page.keyboard.press('ArrowLeft')
  expect(await lab.settled(199)).toBe(hashOf({}, 199))
  await page.keyboard.press('Home')
  expect(await lab.settled(0)).toBe(hashOf({}, 0))
  await expect(plot).toHaveAttribute('aria-valuemax', '200')

  const box = await plot.boundingBox()
  if (!box) throw new Error('no chart')
  await page.mouse.click(box.x + box.width * 0.35, box.y + box.height / 2)
  await expect.poll(() => lab.iteration()).toBeGreaterThan(0)
  const hash = await lab.settled()
  expect(hash).toBe(hashOf({}, await lab.iteration()))
})
