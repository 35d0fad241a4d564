import { readFile } from 'node:fs/promises'
import type { Page } from '@playwright/test'
import { catalogue, type EventKind, type GridScene, type RunEvent, Session } from '../../pkg/node.js'
import { events as text } from '../src/i18n/events.en'
import { presets } from '../src/i18n/presets.en'
import { sights } from '../src/i18n/sights.en'
import { number } from '../src/panels/format'
import { clusters, csv, Kinds, neighbour, nextWithin, present } from '../src/state/events'
import { chosen, offered, PRESETS } from '../src/state/presets'
import { suits } from '../src/state/stops'
import { violations } from './support/axe'
import { hashOf, linkTo, sceneOf, sessionAt } from './support/core'
import { en, expect, type Lab, test } from './support/lab'

/** The published case: of several shortest ways the ants of this seed find the one on which the obstacle comes too near. */
const PUBLISHED = { planner: 'wolf-ant-drive', scene: 'wolf-ant-20', seed: 11 }

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

const event = (iteration: number, kind: string, more: Partial<RunEvent> = {}): RunEvent => ({
  iteration, time: iteration / 10, place: [iteration, 0.5], kind, reason: `${kind}.`, ...more,
})
const KINDS: EventKind[] = [
  { name: 'seen', title: 'Seen', help: '', tone: 'plain' },
  { name: 'turn', title: 'Turns', help: '', tone: 'decision' },
  { name: 'hit', title: 'Collision', help: '', tone: 'bad' },
]
const ROW = [event(10, 'seen'), event(12, 'turn'), event(12, 'hit'), event(13, 'turn'), event(60, 'seen')]

test('events that lie near to each other are one mark, of the gravest tone, where the first of them is', () => {
  const kinds = new Kinds(KINDS)
  const marks = clusters(ROW, kinds, 100, 500, 26)
  expect(marks.map(({ x, tone, events }) => [x, tone, events.length])).toEqual([[50, 'bad', 4], [300, 'plain', 1]])
  expect(marks[0]?.head).toBe(ROW[2])
  // None moves when others follow.
  expect(clusters(ROW.slice(0, 2), kinds, 100, 500, 26).map(({ x }) => x)).toEqual([50])
  expect(clusters([event(3, 'unheard of')], kinds, 100, 500, 26)[0]?.tone).toBe('plain')
})

test('from one event to the next, those of one iteration are one stop', () => {
  expect([neighbour(ROW, 0, true), neighbour(ROW, 10, true), neighbour(ROW, 12, true), neighbour(ROW, 60, true)]).toEqual([10, 12, 13, null])
  expect([neighbour(ROW, 99, false), neighbour(ROW, 13, false), neighbour(ROW, 10, false)]).toEqual([60, 12, null])
  expect([nextWithin(ROW.slice(0, 4), 12), nextWithin(ROW.slice(0, 4), 50)]).toEqual([13, 10])
  expect([present(ROW, 9), present(ROW, 12), present(ROW, 1000)]).toEqual([-1, 2, 4])
})

test('in a table of events a reason may hold commas and quotes', () => {
  const rows = csv([event(10, 'seen', { obstacle: 0, reason: 'Near, "very" near.' }), ROW[1] as RunEvent])
  expect(rows).toBe('iteration,time,x,y,kind,obstacle,reason\n10,1,10,0.5,seen,1,"Near, ""very"" near."\n12,1.2,12,0.5,turn,,turn.\n')
})

test('each published case can be run as it is', () => {
  const known = catalogue()
  expect(offered(known)).toEqual(PRESETS)
  expect(PRESETS.map(({ name }) => name).sort()).toEqual(Object.keys(presets.cases).sort())
  for (const preset of PRESETS) {
    const planner = known.planners.find(({ name }) => name === preset.planner)
    const scene = known.scenes.find(({ name }) => name === preset.scene)
    expect(planner && scene && suits(planner, scene)).toBe(true)
    expect(chosen(PRESETS, known, { planner: preset.planner, scene: scene ?? null, params: preset.params })).toBe(preset)
    const session = new Session(preset)
    expect(session.limit).toBeGreaterThan(0)
    session.free()
  }
})

const marks = (page: Page) => page.getByTestId('event-mark')
const rows = (page: Page) => page.getByTestId('event')

test('the published case is one choice away; played to its end it arrives, and the log says what was decided and why', async ({ lab, page }) => {
  const { end, events } = whole(PUBLISHED)
  const [decided] = events.filter(({ kind }) => kind === 'detour')
  if (!decided) throw new Error('nothing was decided')
  await lab.open()
  await expect(page.getByTestId('event-rail')).toHaveCount(0)
  await page.getByTestId('speed').selectOption('Infinity')
  await page.getByTestId('case').selectOption({ label: presets.cases['moving-ants'] })
  await expect(page.getByTestId('case-see')).toContainText(sights['moving-ants'])
  await expect(page.getByTestId('planner')).toHaveValue('wolf-ant-drive')
  await expect(page.getByTestId('scene')).toHaveValue('wolf-ant-20')

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
  await page.keyboard.press('p')
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
  await page.keyboard.press('p')
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
  const moving = [[130, 145, 0, -20], [200, 350, 15, 0], [350, 100, -10, 12], [90, 250, 7, 9], [250, 330, -12, -5], [210, 110, 20, 3]].map(
    ([x = 0, y = 0, vx = 0, vy = 0]) => ({ center: [x, y] as [number, number], radius: 8, velocity: [vx, vy] as [number, number] }),
  )
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
  await page.getByTestId('planner').selectOption('a-star')
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
          .evaluateAll((controls) => controls.filter((control) => control.getBoundingClientRect().height < 43.5).map((control) => control.outerHTML))
        return [...(await violations(lab)), ...(width > viewport.width ? [`${width} wide`] : []), ...(screen === 'phone' ? low : [])]
      }

      test('axe finds nothing wrong with events, their marks and a collision; nothing is too wide or too low', async ({ lab, page }) => {
        await lab.open(linkTo(PUBLISHED, whole(PUBLISHED).end))
        await lab.settled()
        for (const id of ['events', 'result']) await lab.section(id)
        await expect(rows(page).first()).toBeVisible()
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
