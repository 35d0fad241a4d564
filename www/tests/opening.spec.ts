import { gzipSync } from 'node:zlib'
import type { Response } from '@playwright/test'
import { STANDARD } from '../src/catalogue/standard'
import { hashOf, linkTo } from './support/core'
import { en, expect, FIRST, test } from './support/lab'

test('opens and plays by itself, nothing to configure', { tag: '@smoke' }, async ({ lab }) => {
  await lab.open('')
  await expect.poll(() => lab.iteration()).toBeGreaterThan(3)
  await lab.press(en.transport.pause)
  const hash = await lab.settled()
  expect(hash).toBe(hashOf({ ...STANDARD, params: { ...STANDARD.params } }, await lab.iteration()))
  expect((await lab.picture()).colours).toBeGreaterThan(200)
  await lab.page.getByTestId('view-lab').click()
  expect(await lab.settled()).toBe(hash)
  await expect(lab.page.getByTestId('result-strip')).toContainText(/1[2-9]\.\d+/)
})

test('plays to the end and says so', { tag: '@smoke' }, async ({ lab }) => {
  await lab.open()
  await lab.press(en.transport.end)
  expect(await lab.settled(500)).toBe(hashOf({}, 500))
  await expect(lab.root).toHaveAttribute('data-status', 'exhausted')
})

test.describe('where motion is not wanted', () => {
  test.use({ contextOptions: { reducedMotion: 'reduce' } })

  test('it opens paused, with a Play that works', async ({ lab }) => {
    await lab.open('')
    expect(await lab.settled(0)).toBe(hashOf({ ...STANDARD, params: { ...STANDARD.params } }, 0))
    await lab.press(en.transport.play)
    await expect.poll(() => lab.iteration()).toBeGreaterThan(2)
  })
})

test.describe('where the system is dark', () => {
  test.use({ colorScheme: 'dark' })

  test('the page is dark, and can be made light for good', async ({ lab, page }) => {
    await lab.open()
    const brightness = (): Promise<number> =>
      page.evaluate(() => {
        const [r = 0, g = 0, b = 0] = (getComputedStyle(document.body).backgroundColor.match(/[\d.]+/g) ?? []).map(Number)
        return (r + g + b) / 3
      })
    expect(await brightness()).toBeLessThan(60)
    for (let presses = 0; presses < 3 && (await brightness()) < 128; presses += 1) {
      await page.getByTestId('theme').click()
    }
    expect(await brightness()).toBeGreaterThan(200)
    await page.reload()
    await expect.poll(brightness).toBeGreaterThan(200)
  })
})

for (const address of ['', FIRST])
  test(`the first picture needs at most 100 kB of JavaScript and 150 kB of the core: ${address.slice(0, 10) || 'Learn'}`, {
    tag: '@smoke',
  }, async ({ lab, page }) => {
    const loaded: Response[] = []
    page.on('response', (response) => loaded.push(response))
    await lab.open(address)
    await page.waitForFunction(() => performance.getEntriesByName('first-picture').length > 0)
    const seen = await page.evaluate(() => performance.timeOrigin + (performance.getEntriesByName('first-picture')[0]?.startTime ?? NaN))
    const before = loaded.filter((response) => response.request().timing().startTime <= seen)
    const size = async (ending: string): Promise<number> => {
      const bodies = await Promise.all(before.filter((response) => response.url().endsWith(ending)).map((response) => response.body()))
      return bodies.reduce((sum, body) => sum + gzipSync(body, { level: 9 }).length, 0)
    }
    const [scripts, core] = [await size('.js'), await size('.wasm')]
    expect(scripts).toBeGreaterThan(50_000)
    expect(scripts).toBeLessThan(100_000)
    expect(core).toBeGreaterThan(50_000)
    // A link needs the part that reads links, too.
    if (address === '') expect(core).toBeLessThan(150_000)
  })

test('a browser whose language is none shows the page all the same', async ({ lab, page }) => {
  await page.addInitScript(() => Object.defineProperty(Navigator.prototype, 'language', { get: () => 'C' }))
  await lab.open(linkTo({}, 5))
  await lab.settled(5)
  await expect(page.getByTestId('section-chart').locator('canvas')).toBeVisible()
})
