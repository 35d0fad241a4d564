import { readFile } from 'node:fs/promises'
import type { Page } from '@playwright/test'
import { catalogue, type GridScene, type RunEvent } from '../../pkg/node.js'
import { events as text } from '../src/locales/en/events'
import { number } from '../src/text/number'
import { csv } from '../src/catalogue/events'
import { violations } from './support/axe'
import { hashOf, linkTo, sceneOf, sessionAt } from './support/core'
import { en, expect, type Lab, test, pick } from './support/lab'

/** The published case: of several shortest ways the ants of this seed find the one on which the obstacle comes too near. */
const PUBLISHED = { planner: 'wolf-ant-drive', scene: 'wolf-ant-20', seed: 23 }

const gridOf = (name: string): GridScene => {
  const scene = sceneOf({ planner: 'a-star', scene: name })
  if (scene.kind !== 'grid') throw new Error(scene.kind)
  return scene
}

/** What comes from below is faster than anybody can get out of its way. */
const STRUCK = {
  planner: 'a-star-drive',
  scene: { ...gridOf('wolf-ant-20'), name: 'struck', moving: [{ center: [30, 390], radius: 15, velocity: [0, -300] }] } as GridScene,
}

/** Where it ends, and all that happened until then. */
const whole = (setup: typeof PUBLISHED | typeof STRUCK): { end: number; events: RunEvent[] } =>
  sessionAt(setup, 1e6, (session) => ({ end: session.iteration, events: session.events() }))

const marks = (page: Page) => page.getByTestId('event-mark')
const rows = (page: Page) => page.getByTestId('event')

test('the published case is one choice away; played to its end it arrives, and the log says what was decided and why', {
  tag: '@smoke',
}, async ({ lab, page }) => {
  const { end, events } = whole(PUBLISHED)
  const [decided] = events.filter(({ kind }) => kind === 'detour')
  if (!decided) throw new Error('nothing was decided')
  await lab.open()
  await expect(page.getByTestId('event-rail')).toHaveCount(0)
  await page.getByTestId('speed').selectOption('Infinity')
  const shown = catalogue()
    .planners.find(({ name }) => name === 'wolf-ant-drive')
    ?.cases.find(({ name }) => name === 'map')
  await pick(page, 'case', 'wolf-ant-drive.map')
  await lab.tab('explain')
  await expect(page.getByTestId('case-see')).toContainText(shown?.help ?? 'nothing')
  await lab.tab('chart')
  await expect(page.getByTestId('planner')).toHaveAttribute('data-value', 'wolf-ant-drive')
  await expect(page.getByTestId('scene')).toHaveAttribute('data-value', 'wolf-ant-20')

  expect(await lab.settled(end)).toBe(hashOf(PUBLISHED, end))
  await expect(lab.root).toHaveAttribute('data-status', 'solved')
  // Where it ends is only known on the way.
  await expect(lab.root).toHaveAttribute('data-limit', String(end))
  await expect(page.getByTestId('fate')).toContainText(text.fate.arrived, { ignoreCase: true })
  await expect(page.getByTestId('fate')).toHaveAttribute('data-tone', 'good')
  await expect(page.locator('[data-tone="bad"]')).toHaveCount(0)
  await expect(page.getByTestId('clock')).toHaveText(text.seconds((events.at(-1)?.time ?? 0).toFixed(1)))

  await expect(rows(page)).toHaveCount(events.length)
  const row = page.getByTestId('event-log').locator('[data-kind="detour"]')
  await expect(row).toContainText(decided.reason)
  await expect(row).toContainText(text.obstacle(number((decided.obstacle ?? NaN) + 1)))
  await expect(rows(page).last()).toHaveAttribute('aria-current', 'step')

  const card = await lab.section('result')
  await expect(card.getByTestId('fate-full')).toContainText(text.fate.arrivedAfter(number(events.at(-1)?.time)))
  await expect(card.locator('[data-figure="collisions"]')).toHaveText('0')
})

test('a mark says what happened, and a click on it jumps there; what comes later stays known', async ({ lab, page }) => {
  const { end, events } = whole(PUBLISHED)
  await lab.open(linkTo(PUBLISHED, end))
  await lab.settled(end)
  const first = events[0]?.iteration ?? NaN
  await expect(marks(page).first()).toHaveAttribute('data-iteration', String(first))
  await marks(page).first().hover()
  const words = page.getByTestId('event-words')
  for (const { reason } of events.filter(({ iteration }) => iteration === first)) await expect(words).toContainText(reason)
  await page.keyboard.press('Escape')
  await expect(words).toHaveCount(0)

  await marks(page).first().click()
  expect(await lab.settled(first)).toBe(hashOf(PUBLISHED, first))
  await expect(rows(page)).toHaveCount(events.length)
  await expect(rows(page).last()).toHaveAttribute('data-later', 'true')
  await expect(marks(page).last()).toHaveAttribute('data-later', 'true')
  await expect(marks(page).first()).toHaveAttribute('aria-current', 'true')

  await rows(page).last().click()
  await lab.settled(end)
  await expect(page.locator('[data-later="true"]')).toHaveCount(0)
})

test('N and P go from event to event, on the stage, on the timeline and among the marks', async ({ lab, page }) => {
  const { end, events } = whole(PUBLISHED)
  const stops = [...new Set(events.map(({ iteration }) => iteration))]
  const [first = NaN, second = NaN] = stops
  await lab.open(linkTo(PUBLISHED, end))
  await lab.settled(end)
  await expect(marks(page).first()).toBeVisible()
  await lab.stage.focus()
  await page.keyboard.press('Shift+N')
  await lab.settled(stops.at(-2))
  await lab.seek(0)
  await lab.timeline.focus()
  await page.keyboard.press('n')
  await lab.settled(first)
  await page.keyboard.press('n')
  await lab.settled(second)

  // With arrows from mark to mark; they are one stop of the tab key.
  await page.keyboard.press('Shift+Tab')
  await page.keyboard.press('Home')
  await expect(marks(page).first()).toBeFocused()
  await page.keyboard.press('ArrowRight')
  await expect(marks(page).nth(1)).toBeFocused()
  // How many events share a mark depends on the timeline's width.
  const there = Number(await marks(page).nth(1).getAttribute('data-iteration'))
  expect(there).toBeGreaterThan(first)
  await expect(page.getByTestId('event-words')).toContainText(events.find(({ iteration }) => iteration === there)?.reason ?? 'none')
  await page.keyboard.press('Shift+N')
  await lab.settled(first)
  await page.keyboard.press('Enter')
  await lab.settled(there)
  // In a field they are letters.
  await page.getByTestId('seed').focus()
  await page.keyboard.press('n')
  await lab.settled(there)
})

test('what calls for attention is told to those who don’t see it', async ({ lab, page }) => {
  const { end, events } = whole(PUBLISHED)
  const decided = events.find(({ kind }) => kind === 'detour')
  await lab.open(linkTo(PUBLISHED, end))
  await lab.settled(end)
  await lab.seek(decided?.iteration ?? NaN)
  await expect(page.getByTestId('events-told')).toContainText(decided?.reason ?? '')
  await expect(page.getByTestId('events-told')).toHaveAttribute('aria-live', 'polite')
})

test('a collision is an alarm in the result, on the timeline and in the log, and can’t be filtered away', async ({ lab, page }) => {
  const { end, events } = whole(STRUCK)
  const hit = events.find(({ kind }) => kind === 'collision')
  if (!hit) throw new Error('nothing was hit')
  await lab.open(linkTo(STRUCK, end))
  await lab.settled(end)
  const said = text.fate.collisions('1')
  await expect(page.getByTestId('fate')).toContainText(text.fate.arrivedStruck(said), { ignoreCase: true })
  await expect(page.getByTestId('fate')).toHaveAttribute('data-tone', 'bad')
  await expect(page.getByTestId('live')).toContainText(en.live.collisions('1'))
  await expect(page.locator('[data-testid="event-mark"][data-tone="bad"]')).toHaveCount(1)
  await expect(page.getByTestId('event-log').locator('[data-kind="collision"]')).toContainText(hit.reason)
  await expect(page.getByTestId('filter-collision')).toHaveCount(0)
  await expect((await lab.section('result')).getByTestId('fate-full')).toContainText(said)

  // Before it came about there was none; it is known that it will.
  await lab.seek(hit.iteration - 1)
  await expect(page.getByTestId('fate')).toContainText(text.fate.underway, { ignoreCase: true })
  await expect(page.locator('[data-testid="event-mark"][data-tone="bad"]')).toHaveCount(1)
})

test('of many events some kinds can be left out, and the table has them all', async ({ lab, page }) => {
  const moving = [
    [130, 145, 0, -20],
    [200, 350, 15, 0],
    [350, 100, -10, 12],
    [90, 250, 7, 9],
    [250, 330, -12, -5],
    [210, 110, 20, 3],
  ].map(([x = 0, y = 0, vx = 0, vy = 0]) => ({ center: [x, y] as [number, number], radius: 8, velocity: [vx, vy] as [number, number] }))
  const many = { planner: 'a-star-drive', scene: { ...gridOf('wolf-ant-20'), name: 'many', moving }, params: { border: 'bounce' } }
  const events = sessionAt(many, 1e6, (session) => session.events())
  const seen = events.filter(({ kind }) => kind === 'seen').length
  await lab.open(linkTo(many, 1000))
  await lab.settled()
  await expect(rows(page)).toHaveCount(events.length)
  await page.getByTestId('filter-seen').click()
  await expect(rows(page)).toHaveCount(events.length - seen)
  await expect(page.getByTestId('events')).toContainText(text.log.hidden(number(seen)))

  const started = page.waitForEvent('download')
  await page.getByTestId('events-csv').click()
  const download = await started
  expect(download.suggestedFilename()).toMatch(/^forage-a-star-drive-many-.*events\.csv$/)
  expect(await readFile(await download.path(), 'utf8')).toBe(csv(events))

  // Another planner, which tells of nothing.
  await pick(page, 'planner', 'a-star')
  await expect(page.getByTestId('event-rail')).toHaveCount(0)
  await expect(page.getByTestId('section-events')).toHaveCount(0)
})

for (const colorScheme of ['light', 'dark'] as const) {
  for (const [screen, viewport] of Object.entries({ desktop: { width: 1440, height: 900 }, phone: { width: 390, height: 844 } })) {
    test.describe(`${screen}, ${colorScheme}`, () => {
      test.use({ colorScheme, viewport, hasTouch: screen === 'phone' })

      /** What is wrong with the page for those who look, hear or touch. */
      async function wrong(lab: Lab): Promise<string[]> {
        const { page } = lab
        const width = await page.evaluate(() => document.documentElement.scrollWidth)
        const low = await page
          .locator('[data-testid="events"] button, [data-testid="event-mark"], [data-testid="case"]')
          .evaluateAll((controls) =>
            controls.filter((control) => control.getBoundingClientRect().height < 43.5).map((control) => control.outerHTML),
          )
        return [...(await violations(lab)), ...(width > viewport.width ? [`${width} wide`] : []), ...(screen === 'phone' ? low : [])]
      }

      test('axe finds nothing wrong with events, their marks and a collision; nothing is too wide or too low', async ({ lab, page }) => {
        await lab.open(linkTo(PUBLISHED, whole(PUBLISHED).end))
        await lab.settled()
        for (const id of ['events', 'result']) await lab.section(id)
        await expect(rows(page).first()).toBeVisible()
        expect(await wrong(lab)).toEqual([])
        if (screen === 'phone') await lab.peek()
        await marks(page).first().hover()
        await expect(page.getByTestId('event-words')).toBeVisible()
        expect(await wrong(lab)).toEqual([])
        await lab.seek(150)
        expect(await wrong(lab)).toEqual([])

        await lab.open(linkTo(STRUCK, whole(STRUCK).end))
        await lab.settled()
        await expect(page.getByTestId('fate')).toBeVisible()
        expect(await wrong(lab)).toEqual([])
      })
    })
  }
}
