import { readFile } from 'node:fs/promises'
import { catalogue, type GridScene, type Point, type Scene, type TourScene } from '../../pkg/node.js'
import { cellAt, isBlocked } from '../src/scene/cells'
import { blamed } from '../src/scene/edits'
import { stopsOf, suits } from '../src/scene/stops'
import { violations } from './support/axe'
import { hashOf, linkTo, sceneOf, sessionAt, verified } from './support/core'
import { en, expect, type Lab, test, pick } from './support/lab'

/** Roads by an exact search: quickly built. */
const BATS = { planner: 'bat', scene: 'ant-bat-30', params: { roads: 'a-star' } }
/** The roads are there, and tours with them. */
const AT = 20

const text = en.stops
const grid = (scene: Scene): GridScene => {
  if (scene.kind !== 'grid') throw new Error(scene.kind)
  return scene
}
const tour = (scene: Scene): TourScene => {
  if (scene.kind !== 'tour') throw new Error(scene.kind)
  return scene
}

const shipped = grid(sceneOf(BATS))
const stops = stopsOf(shipped)
const stop = (index: number): Point => stops[index] ?? [NaN, NaN]

const POINTS: Point[] = [
  [10, 10],
  [60, 5],
  [95, 40],
  [70, 75],
  [30, 80],
  [5, 50],
  [45, 40],
]
/** Of the tour in the points' order. */
const LENGTH = POINTS.reduce(
  (sum, [x, y], i) => sum + Math.hypot(x - (POINTS.at(i - 1)?.[0] ?? NaN), y - (POINTS.at(i - 1)?.[1] ?? NaN)),
  0,
)
const plane: TourScene = { format: 'forage-scene', version: 1, kind: 'tour', name: 'seven', title: 'Seven stops', points: POINTS }
const given: TourScene = {
  format: 'forage-scene',
  version: 1,
  kind: 'tour',
  name: 'given',
  title: 'Given distances',
  matrix: [
    [0, 2, 3],
    [2, 0, 4],
    [3, 4, 0],
  ],
}

async function begin(lab: Lab, at = AT): Promise<string> {
  await lab.open(linkTo(BATS, at))
  return lab.settled(at)
}

/** The scene that the address tells, once the run stands at `iteration`. */
async function sceneAt(lab: Lab, iteration: number): Promise<Scene> {
  return verified(await lab.link(await lab.seek(iteration))).scene
}

async function drag(lab: Lab, scene: Scene, from: Point, to: Point): Promise<void> {
  const [a, b] = [await lab.whereIs(scene, from), await lab.whereIs(scene, to)]
  await lab.dragFrom(a, b.x - a.x, b.y - a.y)
}

async function openFile(lab: Lab, scene: Scene): Promise<void> {
  await lab.section('scene')
  await lab.page
    .getByTestId('scene-file')
    .setInputFiles({ name: 'scene.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(scene)) })
  await expect(lab.page.getByTestId('section-scene').getByText(scene.title, { exact: true })).toBeVisible()
  await lab.restarted()
}

test('a stop is dragged to the middle of another cell; what the file knew of the old ones is gone; undo brings it back', async ({
  lab,
}) => {
  const before = await begin(lab)
  await drag(lab, shipped, stop(4), [5.3, 11.8])
  const edited = await sceneAt(lab, 13)
  expect(stopsOf(edited)).toEqual(stops.with(4, [5.5, 11.5]))
  expect([edited.exact, edited.published]).toEqual([undefined, undefined])
  expect(await lab.settled(13)).toBe(hashOf({ ...BATS, scene: edited }, 13))
  await lab.press(en.bar.undo)
  expect(await lab.seek(AT)).toBe(before)
})

test('stops are added with the tool and with a double click, and deleted', async ({ lab, page }) => {
  await begin(lab)
  await page.getByTestId('add-stop').click()
  const at = await lab.whereIs(shipped, [25.4, 6.6])
  await page.mouse.click(at.x, at.y)
  expect(stopsOf(await sceneAt(lab, 2))).toEqual([...stops, [25.5, 6.5]])
  await page.getByTestId('remove-stop').click()
  expect(stopsOf(await sceneAt(lab, 3))).toEqual(stops)
  await expect(page.getByTestId('remove-stop')).toBeDisabled()

  await page.mouse.dblclick(at.x, at.y)
  expect(stopsOf(await sceneAt(lab, 4))).toHaveLength(13)
  const first = await lab.whereIs(shipped, stop(0))
  await page.mouse.click(first.x, first.y)
  await lab.stage.focus()
  await page.keyboard.press('Delete')
  expect(stopsOf(await sceneAt(lab, 5))).toEqual([...stops.slice(1), [25.5, 6.5]])
})

test('stops are moved, deleted and added with the keyboard alone', async ({ lab, page }) => {
  await begin(lab)
  await lab.tab('setup')
  await page.getByTestId('section-scene').locator('> summary').focus()
  await page.keyboard.press('Enter')
  const x = page.getByLabel(en.scene.field(text.name(3), en.scene.x), { exact: true })
  await x.focus()
  await lab.stage.focus()
  await page.keyboard.press('ArrowDown')
  await page.keyboard.press('ArrowLeft')
  // A stop goes from cell to cell.
  expect(stopsOf(await sceneAt(lab, 2))[2]).toEqual([27.5, 25.5])
  await lab.stage.focus()
  await page.keyboard.press('Delete')
  expect(stopsOf(await sceneAt(lab, 3))).toEqual(stops.filter((_, index) => index !== 2))

  await page.getByTestId('list-add-stop').focus()
  await page.keyboard.press('Enter')
  const added = grid(await sceneAt(lab, 4))
  expect(stopsOf(added)).toHaveLength(12)
  const cell = cellAt(added, stopsOf(added)[11] ?? [-1, -1])
  expect(cell && isBlocked(added, cell)).toBe(false)

  await x.fill('26.25')
  await x.press('Enter')
  expect(stopsOf(await sceneAt(lab, 5))[2]?.[0]).toBe(26.25)
})

test('a stop in a wall is refused with the core’s words, and undone', async ({ lab, page }) => {
  const before = await begin(lab)
  expect(isBlocked(shipped, cellAt(shipped, [10.5, 7.5]) ?? { column: -1, row: -1 })).toBe(true)
  await drag(lab, shipped, stop(4), [10.5, 7.5])
  const message = page.getByRole('alert').filter({ hasText: 'stops[4]' })
  await expect(message.first()).toBeVisible()
  expect(blamed('stops[4]')).toEqual({ kind: 'stop', index: 4 })
  await page.keyboard.press('ControlOrMeta+z')
  await expect(message).toHaveCount(0)
  expect(await lab.seek(AT)).toBe(before)
})

test('with a single stop left the planner stays and says what it needs', async ({ lab, page }) => {
  const two: GridScene = { ...shipped, name: 'two', title: 'Two stops', stops: [stop(4), stop(5)] }
  await lab.open(linkTo({ ...BATS, scene: two }, 2))
  await lab.settled(2)
  await lab.section('scene')
  await page.getByRole('button', { name: en.scene.remove(text.name(2)), exact: true }).click()
  await expect(page.getByTestId('scene-error')).toContainText('two stops')
  await expect(page.getByTestId('planner')).toHaveAttribute('data-value', 'bat')
  await expect(page.getByTestId('notice')).toHaveCount(0)
  await page.getByTestId('list-add-stop').click()
  await expect(page.getByTestId('scene-error')).toHaveCount(0)
})

test('a stop says which it is and when the tour calls at it', async ({ lab, page }) => {
  await begin(lab)
  const order = sessionAt(BATS, AT, (session) => session.outcome().order) ?? []
  const { x, y } = await lab.whereIs(shipped, stop(4))
  await page.mouse.move(x, y)
  const card = page.getByTestId('stop-card')
  await expect(card).toHaveText(text.told(5, order.indexOf(4) + 1))
  await lab.layer('stops', false)
  await page.mouse.move(x, y)
  await expect(card).toHaveText(text.told(5, null))
  await page.mouse.move(x + 60, y - 45)
  await expect(card).toHaveCount(0)
  expect([1, 2, 3, 11, 22].map((n) => text.told(1, n))).toEqual(
    ['1st', '2nd', '3rd', '11th', '22nd'].map((nth) => `Stop 1, ${nth} on the tour`),
  )
})

test('the picture tells the order and the direction; so does the drawing', async ({ lab, page }) => {
  await begin(lab)
  const whole = await lab.wholePicture()
  for (const role of ['stops', 'tour', 'roads']) {
    await lab.layer(role, false)
    expect((await lab.picture()).digest).not.toBe(whole.digest)
    await lab.layer(role, true)
  }
  expect((await lab.wholePicture()).digest).toBe(whole.digest)
  await lab.press(en.bar.exports)
  const started = page.waitForEvent('download')
  await page.getByTestId('export-svg').click()
  const svg = (await readFile(await (await started).path())).toString()
  expect(svg.match(/<text/g)?.length).toBeGreaterThanOrEqual(stops.length)
  expect(svg).toContain('<path')
})

test('a tour scene is opened from a file and drawn; its points are dragged, and ways are closed or open', async ({ lab, page }) => {
  await begin(lab)
  await openFile(lab, { ...plane, exact: { length: LENGTH, order: [0, 1, 2, 3, 4, 5, 6] } })
  await expect(page.getByTestId('planner')).toHaveAttribute('data-value', 'bat')
  await expect(page.getByTestId('stop-count')).toHaveText('7')
  await lab.seek(5)
  expect((await lab.picture()).colours).toBeGreaterThan(20)

  await drag(lab, plane, [45, 40], [45, 55])
  const moved = tour(await sceneAt(lab, 4))
  const [x = NaN, y = NaN] = moved.points?.[6] ?? []
  expect(Math.hypot(x - 45, y - 55)).toBeLessThan(1)
  expect(moved.points?.slice(0, 6)).toEqual(POINTS.slice(0, 6))
  expect(moved.exact).toBeUndefined()

  await page.getByTestId('closed').uncheck()
  await page.getByTestId('metric').selectOption('ceil-2d')
  const open = tour(await sceneAt(lab, 3))
  expect([open.closed, open.metric]).toEqual([false, 'ceil-2d'])
  expect(await lab.settled(3)).toBe(
    hashOf({ planner: 'bat', scene: open, params: verified(await lab.link(await lab.settled(3))).params }, 3),
  )

  const { x: left, y: top } = await lab.whereIs(plane, [20, 30])
  await page.mouse.dblclick(left, top)
  expect(tour(await sceneAt(lab, 2)).points).toHaveLength(8)
})

test('stops of given distances are drawn, and stay where they are', async ({ lab, page }) => {
  await begin(lab)
  await openFile(lab, given)
  await expect(page.getByTestId('given')).toBeVisible()
  await expect(page.getByTestId('add-stop')).toHaveCount(0)
  await lab.seek(2)
  await drag(lab, given, stopsOf(given)[1] ?? [0, 0], [0, 0])
  await lab.stage.focus()
  await page.keyboard.press('Delete')
  expect(await sceneAt(lab, 3)).toEqual(given)
  expect(
    stopsOf({ ...given, matrix: Array.from({ length: 4 }, () => [0, 0, 0, 0]) }).map((at) => at.map((c) => Math.round(c) + 0)),
  ).toEqual([
    [0, 1],
    [1, 0],
    [0, -1],
    [-1, 0],
  ])
})

test('of hundreds of stops a part is listed, with the one that is selected', async ({ lab, page }) => {
  await begin(lab)
  const points = Array.from({ length: 120 }, (_, at): Point => [at % 12, Math.floor(at / 12)])
  const many: TourScene = { ...plane, name: 'many', title: 'Many stops', points }
  await openFile(lab, many)
  await expect(page.getByTestId('stops').locator('tbody tr')).toHaveCount(40)
  const { x, y } = await lab.whereIs(many, [11, 9])
  await page.mouse.click(x, y)
  await expect(page.getByLabel(en.scene.field(text.name(120), en.scene.x), { exact: true })).toBeVisible()
  await expect(page.getByTestId('stop-rows')).toHaveText(text.list(81, 120, 120))
  await page.getByRole('button', { name: text.earlier, exact: true }).click()
  await expect(page.getByTestId('stop-rows')).toHaveText(text.list(41, 80, 120))
})

test('planners and scenes that suit each other are brought together', async ({ lab, page }) => {
  await lab.open(linkTo({ planner: 'a-star', scene: 'wolf-ant-20' }, 2))
  await lab.settled(2)
  await pick(page, 'planner', 'bat')
  const scene = await sceneAt(lab, 1)
  expect(stopsOf(scene).length).toBeGreaterThan(1)
  const bat = catalogue().planners.find(({ name }) => name === 'bat')
  if (!bat) throw new Error('no bats')
  const expected = catalogue()
    .scenes.filter((candidate) => suits(bat, candidate))
    .map(({ name }) => name)
  await page.getByTestId('scene').click()
  const listed = await page
    .locator('.picker-list [data-option]')
    .evaluateAll((options) => options.map((option) => option.getAttribute('data-option') ?? ''))
  await page.keyboard.press('Escape')
  // After what ships come those of one's own.
  expect(listed.slice(-2)).toEqual(['function', 'random'])
  expect(listed.slice(0, -2).toSorted()).toEqual(expected.toSorted())

  await lab.press(en.bar.undo)
  await expect(page.getByTestId('scene')).toHaveAttribute('data-value', 'wolf-ant-20')
  await expect(page.getByTestId('planner')).toHaveAttribute('data-value', 'a-star')
  await lab.settled(2)
})

test('a grid that has stops and no ends runs, and a planner of ways makes way', async ({ lab, page }) => {
  await lab.open(linkTo({ planner: 'a-star', scene: 'ant-bat-30' }, 2))
  await lab.settled(2)
  const { start: _start, goal: _goal, exact: _exact, published: _published, ...rest } = shipped
  const endless: GridScene = { ...rest, name: 'endless', title: 'No ends' }
  await openFile(lab, endless)
  await expect(page.getByTestId('planner')).toHaveAttribute('data-value', 'bat')
  expect(await sceneAt(lab, 1)).toEqual(endless)
  await page.getByTestId('tool-paint').click()
  await lab.stage.focus()
  await page.keyboard.press('ArrowRight')
  await expect(page.getByTestId('cell')).not.toBeEmpty()
})

const screens = { desktop: { width: 1440, height: 900 }, phone: { width: 390, height: 844 } }

for (const colorScheme of ['light', 'dark'] as const) {
  for (const [screen, viewport] of Object.entries(screens)) {
    test.describe(`${screen}, ${colorScheme}`, () => {
      test.use({ colorScheme, viewport, hasTouch: screen === 'phone' })

      test('axe finds nothing wrong with stops; nothing is too wide or too low', async ({ lab, page }) => {
        const wrong = async (): Promise<string[]> => {
          const width = await page.evaluate(() => document.documentElement.scrollWidth)
          const low = await page
            .locator('[data-testid="section-scene"], [data-testid="stage"] ~ .tools')
            .locator('button, select, input:not([type=checkbox], [hidden])')
            .evaluateAll((controls) =>
              controls
                .filter((control) => control.getBoundingClientRect().width > 0 && control.getBoundingClientRect().height < 43.5)
                .map((control) => control.outerHTML),
            )
          return [...(await violations(lab)), ...(width > viewport.width ? [`${width} wide`] : []), ...(screen === 'phone' ? low : [])]
        }
        await begin(lab)
        await lab.section('scene')
        await page.getByLabel(en.scene.field(text.name(2), en.scene.y), { exact: true }).focus()
        await expect(page.getByTestId('stop-card')).toBeVisible()
        expect(await wrong()).toEqual([])
        await openFile(lab, plane)
        expect(await wrong()).toEqual([])
        await openFile(lab, given)
        expect(await wrong()).toEqual([])
      })
    })
  }
}

test.describe('on a phone', () => {
  test.use({ viewport: screens.phone, hasTouch: true, isMobile: true })

  test('a finger drags a stop', async ({ lab, page }) => {
    await begin(lab)
    const { x, y } = await lab.whereIs(shipped, stop(8))
    const to = await lab.whereIs(shipped, [24.5, 24.5])
    const finger = await page.context().newCDPSession(page)
    await finger.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: [{ x, y }] })
    for (let part = 0.2; part < 1.1; part += 0.2) {
      await finger.send('Input.dispatchTouchEvent', {
        type: 'touchMove',
        touchPoints: [{ x: x + part * (to.x - x), y: y + part * (to.y - y) }],
      })
    }
    await finger.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] })
    expect(stopsOf(await sceneAt(lab, 3))[8]).toEqual([24.5, 24.5])
  })
})
