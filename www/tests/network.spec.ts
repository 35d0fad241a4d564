import type { Page } from '@playwright/test'
import { hashOf, linkTo } from './support/core'
import { en, expect, test, pick } from './support/lab'
import { scenes } from '../src/locales/en/scenes'

/* Parts of the core that come late, or not at all. */

const GRID = /grid[^/]*\.wasm$/
const FILES = /files[^/]*\.wasm$/
const GENERATORS = /generators[^/]*\.wasm$/

/** The part for grids waits until it is let through. */
async function hold(page: Page): Promise<() => void> {
  let pass = (): void => undefined
  const passed = new Promise<void>((resolve) => (pass = resolve))
  await page.route(GRID, async (route) => {
    await passed
    await route.continue()
  })
  return pass
}

test('a pause while a part is loaded holds for the run that needs it', async ({ lab, page }) => {
  const pass = await hold(page)
  await lab.open(linkTo({}, 0))
  await lab.settled(0)
  await lab.press(en.transport.play)
  await pick(page, 'planner', 'a-star')
  await expect(lab.root).toHaveAttribute('data-stale', 'true')
  await lab.press(en.transport.pause)
  pass()
  await lab.restarted()
  const scene = (await page.getByTestId('scene').getAttribute('data-value')) ?? ''
  expect(await lab.settled(0)).toBe(hashOf({ planner: 'a-star', scene }, 0))
  await expect(lab.root).toHaveAttribute('data-playing', 'false')
})

test('a seek while a part is loaded holds for the run that needs it', async ({ lab, page }) => {
  const pass = await hold(page)
  await lab.open(linkTo({}, 0))
  await lab.settled(0)
  await pick(page, 'planner', 'a-star')
  await expect(lab.root).toHaveAttribute('data-stale', 'true')
  await lab.timeline.fill('7')
  pass()
  await lab.restarted()
  const scene = (await page.getByTestId('scene').getAttribute('data-value')) ?? ''
  expect(await lab.settled(7)).toBe(hashOf({ planner: 'a-star', scene }, 7))
})

/** The browser reports each request that fails: that is what is tested here. */
const offline = test.extend({ watched: async ({ page: _ }, use) => use(undefined) })

offline('a part that cannot be loaded is said, and loaded when it is tried again', async ({ lab, page }) => {
  await page.route(GRID, (route) => route.abort())
  await lab.open(linkTo({}, 0))
  await lab.settled(0)
  await pick(page, 'planner', 'a-star')
  await expect(page.getByTestId('unloaded')).toBeVisible()
  await expect(page.getByTestId('crash')).toHaveCount(0)
  await expect(page.locator('.note.wrong')).toHaveCount(0)
  await page.unroute(GRID)
  await page.getByTestId('retry').click()
  await expect(page.getByTestId('unloaded')).toHaveCount(0)
  await lab.restarted()
  const scene = (await page.getByTestId('scene').getAttribute('data-value')) ?? ''
  expect(await lab.seek(7)).toBe(hashOf({ planner: 'a-star', scene }, 7))
})

offline('what needs a part that cannot be loaded is had when it is tried again: a link, a map, a random map', async ({ lab, page }) => {
  const unloaded = page.getByTestId('unloaded')
  const setup = { planner: 'a-star', scene: 'rooms-20' }
  await page.route(GRID, (route) => route.abort())
  await lab.open(linkTo(setup, 7))
  await expect(unloaded).toContainText(en.notices.link(''))
  // Meanwhile there is something to see.
  await lab.restarted()
  await page.unroute(GRID)
  await page.getByTestId('retry').click()
  await expect(unloaded).toHaveCount(0)
  await lab.restarted()
  expect(await lab.settled(7)).toBe(hashOf(setup, 7))

  await page.route(FILES, (route) => route.abort())
  const map = Buffer.from('type octile\nheight 3\nwidth 4\nmap\n....\n.@@.\n....\n')
  await lab.section('scene')
  await page.getByTestId('scene-file').setInputFiles({ name: 'nook.map', mimeType: 'text/plain', buffer: map })
  await expect(unloaded).toContainText(scenes.imported.files(''))
  await page.unroute(FILES)
  await page.getByTestId('retry').click()
  await expect(unloaded).toHaveCount(0)
  await expect(page.getByTestId('scene')).toHaveValue(/nook/)

  await page.route(GENERATORS, (route) => route.abort())
  await page.getByTestId('generate').click()
  const again = page.getByTestId('make-retry')
  await expect(again).toBeVisible()
  await expect(page.getByTestId('make')).toBeDisabled()
  await page.unroute(GENERATORS)
  await again.click()
  await expect(again).toHaveCount(0)
  await page.getByTestId('make').click()
  await expect(page.getByTestId('generate-dialog')).toHaveCount(0)
})

offline('a dialog that cannot be fetched is said, and the page comes back with it as it was', async ({ lab, page }) => {
  const KEYS = /KeysDialog[^/]*\.js$/
  await page.route(KEYS, (route) => route.abort())
  await lab.open(linkTo({}, 0))
  await lab.settled(0)
  const hash = await lab.seek(7)
  // The part that makes links comes after the first picture.
  await expect(page).toHaveURL(/at=7/)
  await page.keyboard.press('?')
  // The file alone: the rest is in the browser's language.
  await expect(page.getByTestId('unloaded').locator('span')).toHaveText(
    /^A part of the program could not be loaded \(KeysDialog-[\w-]+\.js\)\.$/,
  )
  await page.unroute(KEYS)
  await page.getByTestId('retry').click()
  await expect(page.getByTestId('unloaded')).toHaveCount(0)
  expect(await lab.settled(7)).toBe(hash)
  await page.keyboard.press('?')
  await expect(page.getByTestId('keys-dialog')).toBeVisible()
})
