import type { GridScene, Inspection, Scene } from '../../pkg/node.js'
import { closer } from '../src/locales/en/closer'
import { chance, COMPASS } from '../src/features/explain/compass'
import { number } from '../src/text/number'
import { indexOf, middleOf } from '../src/scene/cells'
import { Walk } from '../src/scene/steps'
import { layerOf, linkTo, sceneOf, sessionAt, verified } from './support/core'
import { en, expect, type Lab, test } from './support/lab'

const ANTS = { planner: 'aco-direction', scene: 'wolf-ant-20' }
const AT = 12

function grid(scene: Scene): GridScene {
  if (scene.kind !== 'grid') throw new Error(scene.kind)
  return scene
}

const scene = grid(sceneOf(ANTS))

/** The frame's pheromone, cell by cell. */
const pheromone = (iteration: number): number[] =>
  sessionAt(ANTS, iteration, (session) => {
    const role = layerOf(session, 'pheromone')
    const { vertices, spans } = session.frame()
    for (let at = 0; at < spans.length; at += 4) {
      const [of, , first = 0, count = 0] = spans.subarray(at, at + 4)
      if (of === role) return Array.from({ length: count }, (_, k) => vertices[4 * (first + k) + 3] ?? NaN)
    }
    throw new Error('no pheromone')
  })

const walkAt = (iteration: number): Walk =>
  sessionAt(ANTS, iteration, (session) => {
    const role = layerOf(session, 'ants')
    const { vertices, spans } = session.frame()
    const pieces: Float32Array[] = []
    for (let at = 0; at < spans.length; at += 4) {
      const [of, , first = 0, count = 0] = spans.subarray(at, at + 4)
      if (of === role) pieces.push(vertices.subarray(4 * first, 4 * (first + count)))
    }
    return Walk.of(pieces)
  })

function told(index: number): Inspection {
  const inspection = sessionAt(ANTS, AT, (session) => session.inspect({ role: 'pheromone', index }))
  if (!inspection) throw new Error(`nothing at ${index}`)
  return inspection
}

async function begin(lab: Lab, iteration = AT): Promise<void> {
  await lab.open(linkTo(ANTS, iteration))
  await lab.settled(iteration)
}

/** The stage's colour at a place of the page. */
const colourAt = (lab: Lab, { x, y }: { x: number; y: number }): Promise<number[]> =>
  lab.stage.evaluate(
    async (stage: HTMLCanvasElement, [x = 0, y = 0]) => {
      await new Promise(requestAnimationFrame)
      const { left, top } = stage.getBoundingClientRect()
      const copy = new OffscreenCanvas(1, 1).getContext('2d')
      copy?.drawImage(stage, Math.round(left - x), Math.round(top - y))
      return [...(copy?.getImageData(0, 0, 1, 1).data ?? [])]
    },
    [x, y],
  )

test('pheromone is a heat map: strong cells are coloured, weak and blocked ones are not, and it follows the iterations', async ({
  lab,
  page,
}) => {
  await begin(lab)
  for (const role of ['trails', 'ants', 'best', 'exact']) await lab.layer(role, false)
  const values = pheromone(AT)
  const [low, high] = [Math.min(...values.filter((value) => value >= 0)), Math.max(...values)]
  await expect(page.getByTestId('range-pheromone')).toHaveText([low, low + (high - low) / 4, high].map((tick) => number(tick, 2)).join(' '))

  const columns = scene.rows[0]?.length ?? 0
  const place = (index: number) => lab.whereIs(scene, middleOf(scene, { column: index % columns, row: Math.floor(index / columns) }))
  const strong = await place(values.indexOf(high))
  const weak = await place(values.indexOf(low))
  const [coloured, plain] = [await colourAt(lab, strong), await colourAt(lab, weak)]
  const picture = await lab.wholePicture()
  await lab.layer('pheromone', false)
  // The thread that draws may be a few frames behind.
  await expect
    .poll(async () => {
      const bare = await colourAt(lab, strong)
      return Math.max(...coloured.map((part, at) => Math.abs(part - (bare[at] ?? 0))))
    })
    .toBeGreaterThan(60)
  expect(await colourAt(lab, weak)).toEqual(plain)
  await lab.layer('pheromone', true)
  expect((await lab.wholePicture()).digest).toBe(picture.digest)

  await lab.seek(AT - 5)
  expect((await lab.wholePicture()).digest).not.toBe(picture.digest)
})

test('an iteration unfolds into its ants’ steps, keeps to the iteration, and folds again', async ({ lab, page }) => {
  await begin(lab)
  const hash = await lab.settled()
  const walk = walkAt(AT)
  await page.getByTestId('unfold').click()
  await expect(page.getByTestId('walk-layer')).toHaveCount(1)
  const line = page.getByTestId('walk-time')
  await expect(line).toHaveAttribute('max', String(walk.end))
  await expect.poll(async () => Number(await line.inputValue())).toBeGreaterThan(1)
  await lab.press(closer.walk.pause)
  for (const step of [0, 7, walk.end]) {
    await line.fill(String(step))
    const { walking, arrived, stuck } = walk.counts(step)
    await expect(line).toHaveAttribute(
      'aria-valuetext',
      `${closer.walk.spoken(number(step), number(walk.end), String(AT))}: ${closer.walk.counts(number(walking), number(arrived), number(stuck))}`,
    )
  }
  await lab.press(closer.walk.back)
  await expect(line).toHaveValue(String(walk.end - 1))

  // The next iteration of the run is unfolded as it comes.
  await lab.press(en.transport.forward)
  await lab.settled(AT + 1)
  await expect(line).toHaveAttribute('max', String(walkAt(AT + 1).end))
  await lab.press(en.transport.back)
  await lab.settled(AT)

  await lab.stage.focus()
  await page.keyboard.press('Home')
  await page.keyboard.press('ArrowRight')
  await page.keyboard.press('Shift+ArrowRight')
  await expect(line).toHaveValue('11')
  await page.keyboard.press('Escape')
  await expect(page.getByTestId('walk')).toHaveCount(0)
  await expect(page.getByTestId('walk-layer')).toHaveCount(0)
  expect(await lab.settled(AT)).toBe(hash)
})

test('playing the run on, or another run, folds what is unfolded', async ({ lab, page }) => {
  await begin(lab)
  await page.getByTestId('unfold').click()
  await expect(page.getByTestId('walk')).toBeVisible()
  await lab.press(en.transport.play)
  await expect(page.getByTestId('walk')).toHaveCount(0)
  await lab.press(en.transport.pause)
  await lab.settled()
  await page.getByTestId('unfold').click()
  await expect(page.getByTestId('walk')).toBeVisible()
  await lab.press(en.transport.newSeed)
  await expect(page.getByTestId('walk')).toHaveCount(0)
})

test.describe('without motion', () => {
  test.use({ reducedMotion: 'reduce' })

  test('an unfolded iteration stands at its beginning until it is played', async ({ lab, page }) => {
    await begin(lab)
    await page.getByTestId('unfold').click()
    await expect(lab.button(closer.walk.play)).toBeVisible()
    await expect(page.getByTestId('walk-time')).toHaveValue('0')
  })
})

test('a cell that is pointed at shows its neighbours with the core’s numbers, while the run plays too; a click pins it', async ({
  lab,
  page,
}) => {
  await begin(lab)
  const cell = { column: 8, row: 11 }
  const index = indexOf(scene, cell)
  const { x, y } = await lab.whereIs(scene, middleOf(scene, cell))
  await page.mouse.move(x, y)
  const card = page.getByTestId('cell-card')
  await expect(card).toHaveAttribute('data-index', String(index))
  const { table, title } = told(index)
  const column = (name: string) => table.columns.findIndex((known) => known.name === name)
  for (const direction of COMPASS.filter((name) => name !== '')) {
    const row = table.rows[table.labels.indexOf(direction)] ?? []
    const place = card.locator(`[data-direction="${direction}"]`)
    if ((row[column('tau')] ?? 0) === 0) {
      await expect(place).toHaveText('–')
      continue
    }
    await expect(place).toContainText(chance(row[column('p')] ?? NaN))
    for (const name of ['tau', 'eta', 'psi'])
      await expect(place.locator(`[data-column="${name}"]`)).toHaveText(number(row[column(name)], 3))
  }
  await page.mouse.move(0, 0)
  await expect(card).toHaveCount(0)

  await page.mouse.click(x, y)
  const panel = page.getByTestId('inspect')
  await expect(panel.getByRole('heading', { level: 2 })).toHaveText(title)
  await expect(panel.getByTestId('compass')).toBeVisible()
  await lab.section('inspect-table')
  await expect(panel.locator('tbody tr')).toHaveCount(8)

  await lab.press(en.transport.play)
  const before = await lab.iteration()
  await page.mouse.move(x + 1, y)
  await expect(card).toHaveAttribute('data-index', String(index))
  await expect.poll(() => lab.iteration()).toBeGreaterThan(before + 5)
  await expect(lab.root).toHaveAttribute('data-playing', 'true')
})

test('a search’s settled cells are a field too; a cell’s card has g, h and f of it and of its neighbours', async ({ lab, page }) => {
  const search = { planner: 'a-star', scene: 'wolf-ant-20' }
  await lab.open(linkTo(search, 60))
  await lab.settled(60)
  for (const role of ['closed', 'frontier']) {
    const { digest } = await lab.wholePicture()
    await lab.layer(role, false)
    expect((await lab.wholePicture()).digest).not.toBe(digest)
    await lab.layer(role, true)
  }
  const cell = { column: 7, row: 7 }
  const inspection = sessionAt(search, 60, (session) => session.inspect({ role: 'closed', index: indexOf(scene, cell) }))
  if (!inspection) throw new Error('nothing there')
  const { x, y } = await lab.whereIs(scene, middleOf(scene, cell))
  await page.mouse.move(x, y)
  const card = page.getByTestId('cell-card')
  const shown = (place: string) => card.locator(place).locator('[data-column]').allTextContents()
  await expect(card).toContainText(inspection.title)
  const own = ['g', 'h', 'f'].map((name) => number(inspection.values.find((value) => value.name === name)?.value, 3))
  expect(await shown('.here')).toEqual(own)
  for (const [at, label] of inspection.table.labels.entries()) {
    expect(await shown(`[data-direction="${label}"]`)).toEqual(inspection.table.rows[at]?.map((value) => number(value, 3)))
  }
})

test('with the lens, keys go from cell to cell, which is told, and look closer', async ({ lab, page }) => {
  await begin(lab)
  await page.getByTestId('tool-cells').click()
  await lab.stage.focus()
  for (const key of ['ArrowRight', 'ArrowDown']) await page.keyboard.press(key)
  const { title, summary } = told(indexOf(scene, { column: 2, row: 2 }))
  await expect(page.getByTestId('cell-told')).toHaveText(`${title}. ${summary}`)
  await page.keyboard.press('Space')
  await expect(page.getByTestId('inspect').getByRole('heading', { level: 2 })).toHaveText(title)
  expect(await lab.iteration()).toBe(AT)
  await page.keyboard.press('Escape')
  await expect(page.getByTestId('tool-cells')).toHaveAttribute('aria-pressed', 'false')
  await expect(page.getByTestId('cell-card')).toHaveCount(0)
})

test('trails are drawn when one looks from near, and only then', async ({ lab }) => {
  const side = 96
  const large: GridScene = {
    format: 'forage-scene',
    version: 1,
    kind: 'grid',
    name: 'large',
    title: 'Large',
    cell: 1,
    rows: Array.from({ length: side }, () => '.'.repeat(side)),
    start: [0.5, 0.5],
    goal: [side - 0.5, side - 0.5],
  }
  await lab.open(linkTo({ planner: 'aco', scene: large }, 5))
  await lab.settled(5)
  /** Whether the layer makes a difference. */
  const drawn = async (): Promise<boolean> => {
    await lab.layer('trails', true)
    const { digest } = await lab.picture()
    await lab.layer('trails', false)
    return (await lab.picture()).digest !== digest
  }
  expect(await drawn()).toBe(false)
  for (let k = 0; k < 5; k += 1) await lab.press(en.stage.zoomIn)
  await lab.layer('trails', true)
  await expect.poll(drawn).toBe(true)
  await lab.press(en.stage.fit)
  await expect.poll(drawn).toBe(false)
})

test('the walls are cleared at once, and undo brings them back', async ({ lab, page }) => {
  await begin(lab)
  const hash = await lab.settled(AT)
  await page.getByTestId('tool-paint').click()
  await page.getByTestId('clear').click()
  await expect(page.getByTestId('clear')).toBeDisabled()
  const cleared = grid(verified(await lab.link(await lab.seek(3))).scene)
  expect(cleared.rows.join('')).not.toContain('#')
  expect(cleared.rows).toHaveLength(scene.rows.length)
  await lab.press(en.bar.undo)
  expect(await lab.seek(AT)).toBe(hash)
})

test('a result names the optimum that it is measured by', async ({ lab, page }) => {
  await begin(lab, 100)
  const legend = page.locator('label').filter({ has: page.getByTestId('layer-exact') })
  await expect(legend).toContainText(en.stage.exact.cells)
  await expect(page.getByTestId('result-strip')).toContainText(en.result.optimum.cells)
  const { turns } = sessionAt(ANTS, 100, (session) => session.outcome())
  await expect(page.getByTestId('turns')).toHaveText(en.result.turns(String(turns)))
  await lab.section('result')
  await expect(page.getByTestId('result').locator('[data-figure="turns"]')).toHaveText(String(turns))

  await lab.open(linkTo({ planner: 'ltqpso', scene: 'qpso-10m' }, 20))
  await lab.settled(20)
  await expect(legend).toContainText(en.stage.exact['any-angle'])
  await expect(page.getByTestId('result-strip')).toContainText(en.result.optimum['any-angle'])
})

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true })

  test('a tap on a cell shows its card, a second one takes it away', async ({ lab, page }) => {
    await begin(lab)
    const { x, y } = await lab.whereIs(scene, middleOf(scene, { column: 10, row: 8 }))
    await page.touchscreen.tap(x, y)
    await expect(page.getByTestId('cell-card')).toHaveAttribute('data-index', String(indexOf(scene, { column: 10, row: 8 })))
    await page.waitForTimeout(500)
    // The explanation has come up from below: the stage is smaller, and the cell elsewhere.
    await expect(page.getByTestId('inspect').getByRole('heading', { level: 2 })).toBeInViewport()
    const again = await lab.whereIs(scene, middleOf(scene, { column: 10, row: 8 }))
    await page.touchscreen.tap(again.x, again.y)
    await expect(page.getByTestId('cell-card')).toHaveCount(0)
  })
})
