import { gzipSync } from 'node:zlib'
import type { Response } from '@playwright/test'
import { hashOf } from './support/core'
import { en, expect, test } from './support/lab'

test('opens and plays by itself, nothing to configure', { tag: '@smoke' }, async ({ lab }) => {
  await lab.open()
  await expect.poll(() => lab.iteration()).toBeGreaterThan(3)
  await lab.press(en.transport.pause)
  const hash = await lab.settled()
  expect(hash).toBe(hashOf({}, await lab.iteration()))
  expect((await lab.picture()).colours).toBeGreaterThan(200)
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
    await lab.open()
    expect(await lab.settled(0)).toBe(hashOf({}, 0))
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

test('the first view needs at most 100 kB of JavaScript', { tag: '@smoke' }, async ({ lab, page }) => {
  const scripts: Response[] = []
  page.on('response', (response) => {
    if (response.url().endsWith('.js')) scripts.push(response)
  })
  await lab.open()
  await expect.poll(() => lab.iteration()).toBeGreaterThan(3)
  // What is still on its way counts too.
  await page.waitForLoadState('networkidle')
  // Bodies are asked for here: one that came later could not be read any more once the test is over.
  const bodies = await Promise.all(scripts.map((response) => response.body()))
  const sizes = bodies.map((body) => gzipSync(body, { level: 9 }).length)
  expect(sizes.length).toBeGreaterThan(0)
  expect(sizes.reduce((sum, size) => sum + size, 0)).toBeLessThan(100_000)
})
