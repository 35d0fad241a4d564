import type { GridScene, Point, Scene } from '../../pkg/node.js'
import { closer } from '../src/locales/en/closer'
import { grids } from '../src/locales/en/grids'
import { moving } from '../src/locales/en/moving'
import { panels } from '../src/locales/en/panels'
import { number } from '../src/text/number'
import { middleOf } from '../src/scene/cells'
import { bends, hashOf, linkTo, sceneOf, sessionAt, verified } from './support/core'
import { en, expect, type Lab, test, pick } from './support/lab'

const GRID = { planner: 'ltqpso', scene: 'qpso-10m' }

function grid(scene: Scene): GridScene {
  if (scene.kind !== 'grid') throw new Error(scene.kind)
  return scene
}

const shipped = grid(sceneOf(GRID))
const corner: Point = [0, 0]

async function sceneAt(lab: Lab, iteration: number): Promise<GridScene> {
  const hash = await lab.seek(iteration)
  return grid(verified(await lab.link(hash)).scene)
}

/** The cells in which two grids differ. */
const difference = (a: GridScene, b: GridScene): string[] =>
  a.rows.flatMap((line, row) => [...line].flatMap((cell, column) => (cell === b.rows[row]?.[column] ? [] : [`${column},${row} ${cell}`])))

test('a grid opens, runs to its end and comes to the core’s hash; its margin is a layer', async ({ lab }) => {
  await lab.open(linkTo(GRID, 0))
  await lab.settled(0)
  await lab.press(en.transport.end)
  expect(await lab.settled(50)).toBe(hashOf(GRID, 50))
  const whole = await lab.wholePicture()
  for (const role of ['margin', 'smoothed', 'best', 'guides']) {
    await lab.layer(role, false)
    expect((await lab.picture()).digest).not.toBe(whole.digest)
    await lab.layer(role, true)
  }
  expect((await lab.wholePicture()).digest).toBe(whole.digest)
})

test('the exact optimum stands among the lengths, and not among costs that are none', async ({ lab, page }) => {
  await lab.open(linkTo(GRID, 50))
  await lab.settled(50)
  const exact = sessionAt(GRID, 0, (session) => session.exact()?.length)
  const chart = page.getByTestId('chart')
  const level = chart.locator('.readout').getByText(panels.chart.exact)
  await expect(chart.getByText('Length', { exact: true })).toBeVisible()
  await expect(level).toHaveCount(0)
  await chart.getByRole('radio', { name: panels.chart.lengths }).check()
  await expect(level).toHaveCount(1)
  await expect(chart.locator('.readout')).toContainText(number(exact, 4))
  await chart.getByRole('radio', { name: panels.chart.schedules }).check()
  await expect(level).toHaveCount(0)
  await expect(page.getByTestId('layer-exact')).toBeChecked()
})

test('the printed path is laid over the stage on request, and not over an edited map', async ({ lab, page }) => {
  const printed = { planner: 'a-star', scene: 'wolf-ant-20', seed: 1 }
  await lab.open(linkTo(printed, 20))
  await lab.settled(20)
  const layer = page.getByTestId('layer-printed')
  await expect(layer).not.toBeChecked()
  const before = await lab.wholePicture()
  await lab.layer('printed', true)
  expect((await lab.wholePicture()).digest).not.toBe(before.digest)
  await expect(page.locator('label').filter({ has: layer })).toHaveAttribute('title', moving.printedHelp(number(562.842712474619, 7)))
  await lab.layer('printed', false)
  expect((await lab.wholePicture()).digest).toBe(before.digest)

  const scene = grid(sceneOf(printed))
  await page.getByTestId('tool-paint').click()
  const { x, y } = await lab.whereIs(scene, middleOf(scene, { column: 0, row: 19 }))
  await page.mouse.click(x, y)
  await expect(layer).toHaveCount(0)
})

test('the case of the printed path drives it: as long as it is printed', async ({ lab, page }) => {
  await lab.open()
  await pick(page, 'case', 'a-star-drive.printed')
  await page.getByTestId('to-end').click()
  await expect(page.locator('[data-status=solved]')).toBeVisible()
  await expect(page.getByTestId('result-strip')).toContainText(number(562.842712474619, 6))
  await expect(page.getByTestId('turns')).toContainText('10')
})

test('the start is dragged, and kept within the grid', async ({ lab }) => {
  await lab.open(linkTo(GRID, 20))
  await lab.settled(20)
  await lab.dragFrom(await lab.whereIs(shipped, shipped.start ?? corner), 30, 60)
  const edited = await sceneAt(lab, 7)
  expect(edited.start?.[0]).toBeGreaterThan(0.2)
  expect(edited.start?.[1]).toBe(0)
  expect(edited.goal).toEqual(shipped.goal)
  expect(await lab.settled(7)).toBe(hashOf({ ...GRID, scene: edited }, 7))
})

test('cells are painted and erased, a stroke is one step, and undo brings back the same run', { tag: '@smoke' }, async ({ lab, page }) => {
  await lab.open(linkTo(GRID, 20))
  const before = await lab.settled(20)
  await page.getByTestId('tool-paint').click()
  const cell = async (column: number, row: number) => lab.whereIs(shipped, middleOf(shipped, { column, row }))
  const [from, to] = [await cell(11, 2), await cell(15, 2)]
  await lab.dragFrom(from, to.x - from.x, to.y - from.y)
  const painted = await sceneAt(lab, 6)
  expect(difference(painted, shipped)).toEqual([11, 12, 13, 14, 15].map((column) => `${column},2 #`))
  expect(await lab.settled(6)).toBe(hashOf({ ...GRID, scene: painted }, 6))

  // A press on a blocked cell erases, also with a tap.
  const wall = await cell(13, 2)
  await page.mouse.click(wall.x, wall.y)
  expect(difference(await sceneAt(lab, 5), painted)).toEqual(['13,2 .'])

  await lab.press(en.bar.undo)
  await lab.press(en.bar.undo)
  expect(await lab.seek(20)).toBe(before)
  expect((await sceneAt(lab, 9)).rows).toEqual(shipped.rows)
})

test('a cell painted onto the start is refused with the core’s words, and undone', async ({ lab, page }) => {
  await lab.open(linkTo(GRID, 20))
  await lab.settled(20)
  await page.getByTestId('tool-paint').click()
  const at = await lab.whereIs(shipped, [0.9, 0.25])
  await page.mouse.move(at.x, at.y)
  await page.mouse.down()
  await page.mouse.move(at.x - 15, at.y, { steps: 3 })
  await page.mouse.move(at.x - 27, at.y, { steps: 3 })
  await page.mouse.up()
  const message = page.getByRole('alert').filter({ hasText: 'start' })
  await expect(message.first()).toContainText('robot fits')
  await page.keyboard.press('ControlOrMeta+z')
  await expect(message).toHaveCount(0)
  expect((await sceneAt(lab, 4)).rows).toEqual(shipped.rows)
})

test('cells are painted with the keyboard, which says what is where', async ({ lab, page }) => {
  await lab.open(linkTo(GRID, 20))
  await lab.settled(20)
  await page.getByTestId('tool-paint').click()
  await lab.stage.focus()
  for (const key of ['ArrowRight', 'ArrowRight', 'ArrowRight', 'ArrowUp', 'ArrowUp']) await page.keyboard.press(key)
  await expect(page.getByTestId('cell')).toHaveText(grids.cell(4, 18, false))
  await page.keyboard.press('Space')
  await expect(page.getByTestId('cell')).toHaveText(grids.cell(4, 18, true))
  expect(difference(await sceneAt(lab, 4), shipped)).toEqual(['3,17 #'])
  await lab.stage.focus()
  await page.keyboard.press('Escape')
  await expect(page.getByTestId('tool-paint')).toHaveAttribute('aria-pressed', 'false')
})

test('a scene whose y grows downwards is painted where it is seen', async ({ lab, page }) => {
  await lab.open(linkTo(GRID, 0))
  const { exact: _, published: __, ...rest } = shipped
  const down: GridScene = { ...rest, name: 'down', title: 'Down', y_axis: 'down' }
  await lab.section('scene')
  await page
    .getByTestId('scene-file')
    .setInputFiles({ name: 'down.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(down)) })
  await expect(page.getByTestId('section-scene').getByText('Down', { exact: true })).toBeVisible()
  await page.getByTestId('tool-paint').click()
  // The first row is on top; its y is the smallest.
  const at = await lab.whereIs(down, [5.25, 0.25])
  expect(at.y).toBeLessThan((await lab.whereIs(down, [5.25, 9.75])).y)
  await page.mouse.click(at.x, at.y)
  expect(difference(await sceneAt(lab, 3), down)).toEqual(['10,0 #'])
})

test('cell and robot are edited in the panel; what the core refuses is said there', async ({ lab, page }) => {
  await lab.open(linkTo(GRID, 10))
  await lab.settled(10)
  await lab.section('scene')
  const set = async (label: string, value: string): Promise<void> => {
    const field = page.getByLabel(label, { exact: true })
    await field.fill(value)
    await field.press('Enter')
  }
  await set(en.scene.cell, '1')
  let scene = await sceneAt(lab, 3)
  expect([scene.cell, scene.goal]).toEqual([1, [20, 20]])
  await set(en.scene.robot.length, '0.8')
  scene = await sceneAt(lab, 4)
  expect(scene.robot).toEqual({ ...shipped.robot, length: 0.8 })
  await set(en.scene.robot.width, '-1')
  await expect(page.getByTestId('scene-error')).toContainText('robot.width')
  await set(en.scene.robot.width, '0.3')
  await expect(page.getByTestId('scene-error')).toHaveCount(0)
})

for (const event of ['leap', 'replaced']) {
  test(`a ${event} is explained with its numbers in the formulas and a key to what is drawn`, async ({ lab, page }) => {
    await lab.open(linkTo(GRID, 4))
    await lab.settled(4)
    // A bend where the core picks a particle to which this happened.
    const reach = 0.05
    const [at, told] = bends(GRID, 4)
      .map((bend) => {
        const inspection = sessionAt(GRID, 4, (session) => {
          const item = session.pick(...bend, reach)
          return item && session.inspect(item)
        })
        return [bend, inspection] as const
      })
      .find(([, inspection]) => inspection?.event === event) ?? [corner, null]
    if (!told) throw new Error(`no ${event}`)
    const { x, y } = await lab.whereIs(shipped, at)
    await page.mouse.click(x, y)
    const panel = page.getByTestId('inspect')
    await expect(panel.getByRole('heading', { level: 2 })).toHaveText(told.title)
    await expect(panel.locator('[data-event]')).toHaveAttribute('data-event', event)
    await lab.section('inspect-values')
    for (const { name, value } of told.values) await expect(panel.locator(`[data-value="${name}"]`)).toHaveText(number(value))
    for (const formula of ['leap', 'attractor', 'phi', 'ip', 'gs'])
      await expect(panel.getByTestId(`live-${formula}`)).not.toContainText('□')
    const key = panel.getByTestId('inspect-key').locator('[data-role]')
    expect(await key.evaluateAll((items) => items.map((item) => item.getAttribute('data-role')))).toEqual([
      'before',
      'mean-best',
      'attractors',
      'jump',
      'after',
    ])
  })
}

test('beside the panels in a narrow window, the tools don’t cover the goal', async ({ lab, page }) => {
  await page.setViewportSize({ width: 960, height: 1080 })
  await lab.open(linkTo(GRID, 20))
  await lab.settled(20)
  const goal = await lab.whereIs(shipped, shipped.goal ?? corner)
  expect(await page.evaluate(({ x, y }) => document.elementFromPoint(x + 8, y)?.getAttribute('data-testid'), goal)).toBe('stage')
  await lab.dragFrom(goal, -60, 60)
  expect((await sceneAt(lab, 3)).goal?.[0]).toBeLessThan(9)
})

test('where walls shut the goal off, the result says that there is no way', async ({ lab, page }) => {
  const shut = { ...shipped, rows: shipped.rows.map((line, row) => (row === 12 ? '#'.repeat(line.length) : line)) }
  await lab.open(linkTo({ ...GRID, scene: shut }, 20))
  await lab.settled(20)
  await lab.section('result')
  await expect(page.getByTestId('result-gap')).toHaveText(closer.result.noWay)
})
