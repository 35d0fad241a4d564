import { readFileSync } from 'node:fs'
import {
  armSlice,
  armSolutions,
  type ArmScene,
  catalogue,
  type Motion,
  type Point3,
  reachability,
  type Scene,
  type Session,
  type UncheckedSetup,
} from '../../pkg/node.js'
import { arm as words } from '../src/locales/en/arm'
import { closer } from '../src/locales/en/closer'
import { number, percent } from '../src/text/number'
import { degrees } from '../src/text/degrees'
import { RIM } from '../src/render/plot/joint-space'
import { Swing } from '../src/scene/trajectory'
import { violations } from './support/axe'
import { hashOf, linkTo, sceneOf, sessionAt, verified } from './support/core'
import { en, expect, type Lab, test, pick } from './support/lab'
import { shot } from './support/space'

const GUIDED = { planner: 'rrt-guided', scene: 'arm-cuboid', seed: 1 }
const JOINTS = { planner: 'rrt-joint', scene: 'arm-cuboid', seed: 1 }
const text = words.motion

const endOf = (setup: Partial<UncheckedSetup>): number => sessionAt(setup, 1e6, (session) => session.iteration)

function armOf(scene: Scene): ArmScene {
  if (scene.kind !== 'arm') throw new Error(scene.kind)
  return scene
}

const shipped = armOf(sceneOf(GUIDED))

/** What the core says of the motion along a run's result. */
function moved(setup: Partial<UncheckedSetup> = GUIDED, params = {}): Motion {
  const motion = sessionAt(setup, 1e6, (session: Session) => session.motion(params))
  if (!motion) throw new Error('no motion')
  return motion
}

async function opened(lab: Lab, setup: Partial<UncheckedSetup> = GUIDED): Promise<string> {
  const end = endOf(setup)
  await lab.open(linkTo(setup, end))
  return lab.settled(end)
}

async function begin(lab: Lab, setup: Partial<UncheckedSetup> = GUIDED): Promise<string> {
  const hash = await opened(lab, setup)
  await lab.section('motion')
  await lab.page.getByTestId('motion-begin').click()
  await expect(lab.page.getByTestId('motion-bar')).toBeVisible()
  return hash
}

/** The first seed for which something holds of the motion. */
function seedWhere(holds: (motion: Motion) => boolean): number | null {
  for (let seed = 1; seed <= 40; seed += 1) if (holds(moved({ ...GUIDED, seed }))) return seed
  return null
}

test('the arm follows the result: verdict, figures and rows are the core’s, and the run stands where it stood', async ({ lab, page }) => {
  const hash = await begin(lab)
  const { outcome } = moved()
  const swing = new Swing(moved())
  const verdict = page.getByTestId('motion-verdict')
  await expect(verdict).toHaveAttribute('data-arrived', String(outcome.arrived))
  await expect(verdict).toHaveAttribute('data-free', String(outcome.free))
  const figure = (name: string) => page.getByTestId('motion-figures').locator(`[data-figure="${name}"]`)
  await expect(figure('time')).toHaveText(`${number(outcome.time)} s`)
  await expect(figure('length')).toHaveText(`${number(outcome.length)} m`)
  await expect(figure('largest_step')).toHaveText(`${number(outcome.largest_step, 3)}°`)
  await expect(figure('max_error')).toHaveText(`${number(outcome.max_error, 3)} m`)

  const time = page.getByTestId('motion-time')
  await expect.poll(async () => Number(await time.inputValue())).toBeGreaterThan(0)
  await page.getByTestId('motion-play').click()
  const middle = Math.round(swing.end * 50) / 100
  await time.fill(String(middle))
  for (const [name, value] of Object.entries(swing.values(swing.row(middle)))) {
    if (name !== 'time') await expect(page.getByTestId('motion').locator(`[data-now="${name}"]`)).toContainText(number(value))
  }

  // From row to row, and with the keys in a chart.
  await page.getByTestId('motion-forward').click()
  const next = swing.neighbour(middle, true)
  await expect.poll(async () => Number(await time.inputValue())).toBeCloseTo(next, 1)
  await page.getByTestId('motion-chart').first().press('End')
  await expect.poll(async () => Number(await time.inputValue())).toBeCloseTo(swing.end, 1)

  await page.getByTestId('motion-leave').click()
  await expect(page.getByTestId('motion-bar')).toHaveCount(0)
  expect(await lab.settled(endOf(GUIDED))).toBe(hash)
})

test('a click in a joint’s chart moves the time', async ({ lab, page }) => {
  await begin(lab)
  await page.getByTestId('motion-play').click()
  const chart = page.getByTestId('motion-chart').nth(2)
  await chart.scrollIntoViewIfNeeded()
  const box = await chart.boundingBox()
  if (!box) throw new Error('no chart')
  const time = page.getByTestId('motion-time')
  const now = async (): Promise<number> => Number(await time.inputValue())
  await page.mouse.click(box.x + box.width * 0.75, box.y + box.height / 2)
  await expect.poll(now).toBeGreaterThan(new Swing(moved()).end / 2)
  const late = await now()
  await page.mouse.click(box.x + box.width * 0.35, box.y + box.height / 2)
  await expect.poll(now).toBeLessThan(late)
})

test('a touch is said plainly, with its time and place, and one click away', async ({ lab, page }) => {
  const seed = seedWhere(({ outcome }) => outcome.touched_at !== undefined)
  expect(seed, 'a seed whose motion touches something').not.toBeNull()
  const setup = { ...GUIDED, seed: seed ?? 1 }
  await begin(lab, setup)
  const swing = new Swing(moved(setup))
  const at = swing.motion.outcome.touched_at ?? NaN
  const [x, y, z] = swing.tipAt(at) ?? []
  await expect(page.getByTestId('motion-verdict')).toContainText(text.touches(number(at, 3), number(x, 3), number(y, 3), number(z, 3)))
  await page.getByTestId('motion-touch').click()
  await expect.poll(async () => Number(await page.getByTestId('motion-time').inputValue())).toBeCloseTo(at, 1)
  await expect(page.getByTestId('result-strip').getByTestId('result-motion')).toHaveAttribute('data-fine', 'false')
})

test('the motion is saved as the core’s rows, from its panel and from the list of exports', async ({ lab, page }) => {
  await begin(lab)
  const { columns, rows } = moved()
  const [first] = await Promise.all([page.waitForEvent('download'), page.getByTestId('motion-csv').click()])
  await page.getByTestId('motion-leave').click()
  await page.getByRole('button', { name: en.bar.exports }).click()
  const [second] = await Promise.all([page.waitForEvent('download'), page.getByTestId('export-motion').click()])
  for (const download of [first, second]) {
    const lines = readFileSync(await download.path(), 'utf8')
      .trimEnd()
      .split('\n')
    expect(lines[0]).toBe(columns.join(','))
    expect(lines).toHaveLength(1 + rows.length / columns.length)
    expect(lines.at(-1)).toBe([...rows.subarray(-columns.length)].join(','))
  }
})

test('the motion’s parameters make another motion; what the core refuses is said beside them', async ({ lab, page }) => {
  const parameter = catalogue().motion.parameters.find(({ type, max }) => type === 'number' && max !== undefined)
  if (!parameter) throw new Error('no parameter')
  await begin(lab)
  await page.getByText(text.parameters, { exact: true }).click()
  const row = page.getByTestId('motion').locator(`[data-parameter="${parameter.name}"]`)
  const field = row.locator('input.typed')
  await field.fill(String((parameter.max ?? 0) + 1))
  await field.press('Enter')
  await expect(row.getByRole('alert')).toContainText(parameter.name)
  const value = Number(parameter.default) * 0.8
  await field.fill(String(value))
  await field.press('Enter')
  await expect(row.getByRole('alert')).toHaveCount(0)
  const { outcome } = moved(GUIDED, { [parameter.name]: value })
  await expect(page.getByTestId('motion-figures').locator('[data-figure="time"]')).toHaveText(`${number(outcome.time)} s`)
})

test('the postures of a point are the core’s, in its order', async ({ lab, page }) => {
  await opened(lab)
  await lab.section('postures')
  const { direction, solutions } = armSolutions(shipped, shipped.goal, null, undefined)
  expect(solutions.length).toBeGreaterThan(0)
  const rows = page.getByTestId('postures').locator('tbody tr')
  await expect(rows).toHaveCount(solutions.length)
  for (const [at, { joints, free }] of solutions.entries()) {
    await expect(rows.nth(at)).toHaveAttribute('data-free', String(free))
    await expect(rows.nth(at).locator('td')).toHaveText([...joints.map(degrees), free ? words.postures.free : words.postures.touches])
  }
  const free = solutions.filter((solution) => solution.free).length
  await expect(page.getByTestId('postures-told')).toHaveText(words.postures.count(solutions.length, free))

  // A row that is gone to is pointed at.
  await rows.nth(0).getByRole('button').focus()
  await expect(rows.nth(0).getByRole('button')).toHaveAttribute('aria-pressed', 'true')

  // With a direction of one's own: opposite to the one that was found.
  await page.getByRole('radio', { name: words.postures.chosen }).check()
  const field = page.getByLabel(words.postures.elevation)
  await field.fill('90')
  await field.press('Enter')
  const up: Point3 = [0, 0, 1]
  expect(direction).not.toEqual(up)
  const above = armSolutions(shipped, shipped.goal, [Math.cos(Math.PI / 2), 0, 1], undefined)
  await expect(rows).toHaveCount(above.solutions.length)
})

test('without a posture it says why', async ({ lab, page }) => {
  // Out of reach whichever way the tool points.
  const far: ArmScene = { ...shipped, name: 'far', arm: { ...shipped.arm, base: { ...shipped.arm.base, position: [-0.3, -0.2, 0] } } }
  expect(armSolutions(far, far.goal, null, undefined).unreachable).toBe('position')
  await lab.open(linkTo({ planner: 'rrt', scene: far, seed: 1 }, 0))
  await lab.section('postures')
  await expect(page.getByTestId('postures-told')).toHaveText(words.postures.unreachable.position)
})

test('where the tip can come is asked for, told, and gone when the scene is another', async ({ lab, page }) => {
  await opened(lab)
  await lab.section('survey')
  await page.getByTestId('survey-step').selectOption('0.2')
  await page.getByTestId('survey-show').click()
  const { points } = reachability(shipped, 0.2)
  const reached = points.filter((share, at) => at % 4 === 3 && share > 0).length
  const all = points.length / 4
  const told = page.getByTestId('survey-told')
  await expect(told).toHaveText(words.survey.told(number(reached), number(all), percent(reached / all)))
  await page.getByTestId('survey-clear').click()
  await expect(told).toBeEmpty()

  await page.getByTestId('survey-show').click()
  await expect(told).not.toBeEmpty()
  await expect(page.getByTestId('survey-clear')).toBeVisible()
  const scene = await lab.section('scene')
  const yaw = scene.getByLabel(words.scene.field(words.scene.base, words.scene.yaw))
  await yaw.fill('15')
  await yaw.press('Enter')
  await expect(page.getByTestId('survey-clear')).toHaveCount(0)
  await expect(told).toBeEmpty()
})

test('a survey that takes long can be called off, and the run goes on meanwhile', async ({ lab, page }) => {
  await lab.open(linkTo({ planner: 'rrt-star', scene: 'arm-cuboid', seed: 1 }, 10))
  await lab.settled(10)
  await lab.section('survey')
  await page.getByTestId('survey-step').selectOption('0.05')
  await page.getByTestId('survey-show').click()
  await expect(page.getByTestId('survey-cancel')).toBeVisible()
  await lab.press(en.transport.forward)
  await lab.settled(11)

  // Called off in the same task of the page in which it is begun: it cannot have come to its end.
  const calledOff = await page.getByTestId('survey').evaluate(async (survey) => {
    const press = async (name: string): Promise<boolean> => {
      const button = (): HTMLButtonElement | null => survey.querySelector(`[data-testid=survey-${name}]`)
      for (let turn = 0; turn < 100 && !button(); turn += 1) await Promise.resolve()
      button()?.click()
      return button() !== null
    }
    if (survey.querySelector('[data-testid=survey-cancel]')) await press('cancel')
    return (await press('show')) && (await press('cancel'))
  })
  expect(calledOff).toBe(true)
  await expect(page.getByTestId('survey-show')).toBeVisible()
  // Whatever is still computed shows nothing when it comes.
  await lab.press(en.transport.forward)
  await lab.settled(12)
  await expect(page.getByTestId('survey-told')).toBeEmpty()
  await expect(page.getByTestId('survey-clear')).toHaveCount(0)
})

test('cuboids, ends and base are edited by numbers, undone, and refused beside the number', async ({ lab, page }) => {
  await opened(lab)
  await lab.section('scene')
  const cuboid = words.scene.cuboid(1)
  const number = (object: string, axis: string) => page.getByRole('textbox', { name: words.scene.field(object, axis), exact: true })
  const put = async (object: string, axis: string, value: string): Promise<void> => {
    await number(object, axis).fill(value)
    await number(object, axis).press('Enter')
  }
  const now = async (): Promise<ArmScene> => {
    return armOf(verified(await lab.link(await lab.seek(3))).scene)
  }
  const high = `${cuboid}, ${words.scene.to}`
  await put(high, 'z', '0.4')
  expect((await now()).cuboids[0]?.max).toEqual([0.45, 0.48, 0.4])

  await put(high, 'z', '-1')
  await expect(page.getByTestId('scene-error').first()).toContainText('cuboids[0].max[2]')
  await expect(number(high, 'z')).toHaveAttribute('aria-invalid', 'true')
  await expect(number(high, 'x')).toHaveAttribute('aria-invalid', 'false')
  await lab.press(en.bar.undo)
  await expect(page.getByTestId('scene-error')).toHaveCount(0)
  await lab.press(en.bar.undo)
  await expect(number(high, 'z')).toHaveValue('0.32')

  await page.getByTestId('list-add-cuboid').click()
  await expect(page.getByTestId('cuboids').locator('tbody')).toHaveCount(2)
  await lab.button(words.scene.remove(cuboid)).click()
  await expect(page.getByTestId('cuboids').locator('tbody')).toHaveCount(1)
  await lab.press(en.bar.undo)
  await lab.press(en.bar.undo)
  await expect(page.getByTestId('cuboids').locator('tbody')).toHaveCount(1)

  await put(words.scene.goal, 'z', '5')
  await expect(page.getByTestId('scene-error').first()).toContainText('goal')
  await lab.press(en.bar.undo)
  await put(words.scene.position, 'x', '0.35')
  expect((await now()).arm.base.position).toEqual([0.35, 0.65, 0.4])
})

test('a cuboid’s middle and size say the same as its corners', async ({ lab, page }) => {
  await opened(lab)
  await lab.section('scene')
  await page.getByRole('radio', { name: words.scene.sizes }).check()
  const size = page.getByRole('textbox', { name: words.scene.field(`${words.scene.cuboid(1)}, ${words.scene.size}`, 'x') })
  await expect(size).toHaveValue('0.2')
  await size.fill('0.1')
  await size.press('Enter')
  await page.getByRole('radio', { name: words.scene.corners }).check()
  const corner = (row: string) => page.getByRole('textbox', { name: words.scene.field(`${words.scene.cuboid(1)}, ${row}`, 'x') })
  await expect(corner(words.scene.from)).toHaveValue('0.3')
  await expect(corner(words.scene.to)).toHaveValue('0.4')
})

test('a node of the guided tree tells its samples, which were kept, and what became of each', async ({ lab, page }) => {
  const setup = { planner: 'rrt-guided', scene: 'wcpso-discs', seed: 3 }
  const end = endOf(setup)
  const scene = sceneOf(setup)
  // One that no disc, end or other node lies over.
  const node = sessionAt(setup, end, (session) => {
    for (let index = 1; index < end; index += 1) {
      const told = session.inspect({ role: 'nodes', index })
      const [place] = told?.layers.find(({ role, shape }) => role === 'after' && shape === 'points')?.vertices ?? []
      const open =
        place &&
        scene.kind === 'discs' &&
        scene.discs.every(({ center, radius }) => Math.hypot(center[0] - place[0], center[1] - place[1]) > radius + 0.3)
      const own = place && session.pick(place[0], place[1], 0.05)
      if (told?.table.rows.length === 20 && open && own?.role === 'nodes' && own.index === index) return { told, place }
    }
    throw new Error('no guided node')
  })
  await lab.open(linkTo(setup, end))
  await lab.settled(end)
  const { x, y } = await lab.whereIs(scene, [node.place[0], node.place[1]])
  await page.mouse.click(x, y)
  const inspect = page.getByTestId('inspect')
  await expect(inspect.locator('h2')).toHaveText(node.told.title)
  await lab.section('inspect-table')
  const rows = inspect.locator('tbody tr')
  await expect(rows.locator('th')).toHaveText(node.told.table.labels)
  const share = node.told.table.columns.findIndex(({ name }) => name === 'share')
  await expect(inspect.locator('tbody tr.kept')).toHaveCount(node.told.table.rows.filter((row) => (row[share] ?? 0) > 0).length)
  await expect(inspect.locator('caption')).toHaveText(closer.inspect.tables.sample.title(node.told.title))
})

test('rrt-joint: the tree in joint space has the core’s nodes; a node chosen there is looked at closer', async ({ lab, page }) => {
  await opened(lab, JOINTS)
  const columns =
    catalogue()
      .planners.find(({ name }) => name === 'rrt-joint')
      ?.members.map(({ name }) => name) ?? []
  const rows = sessionAt(JOINTS, 1e6, (session) => session.members())
  const all = rows.length / columns.length
  await lab.section('joints')
  const space = page.getByTestId('joint-space')
  await expect(space).toHaveAttribute('data-nodes', String(all))
  const view = page.getByTestId('joints-view')
  await view.focus()
  await page.keyboard.press('Home')
  await page.keyboard.press('ArrowRight')
  await page.keyboard.press('ArrowRight')
  const told = sessionAt(JOINTS, 1e6, (session) => session.inspect({ role: 'nodes', index: 2 }))
  await expect(page.getByTestId('inspect').locator('h2')).toHaveText(told?.title ?? '')
  const at = (name: string): number => rows[2 * columns.length + columns.indexOf(name)] ?? NaN
  await expect(page.getByTestId('joints-told')).toContainText(`${degrees(at('q1'))}°, ${degrees(at('q2'))}°`)

  // Up leads to the parent; a root has none.
  await page.keyboard.press('ArrowUp')
  const parent = rows[2 * columns.length + columns.indexOf('parent')] ?? -1
  const above = sessionAt(JOINTS, 1e6, (session) => session.inspect({ role: 'nodes', index: parent >= 0 ? parent : 2 }))
  await expect(page.getByTestId('inspect').locator('h2')).toHaveText(above?.title ?? '')
  await page.keyboard.press('Escape')
  await expect(page.getByTestId('inspect').locator('h2')).toHaveCount(0)

  // Where the arm would touch something is shaded: the pixels of the plot say what the core does.
  await expect(space.locator('[data-touching]')).toHaveAttribute('data-touching', 'true')
  const scene = sceneOf(JOINTS)
  if (scene.kind !== 'arm') throw new Error(scene.kind)
  const [a, b] = scene.arm.joints
  const root = columns.flatMap((name, at) => (/^q[1-6]$/.test(name) ? [rows[at] ?? NaN] : []))
  const cells = armSlice(scene, root, [0, 1], [a?.min ?? 0, b?.min ?? 0], [a?.max ?? 0, b?.max ?? 0], 0)
  const share = cells.reduce((sum, cell) => sum + cell, 0) / cells.length
  const shaded = await view.evaluate((canvas: HTMLCanvasElement) => {
    const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', { willReadFrequently: true })
    if (!copy) return NaN
    copy.drawImage(canvas, 0, 0)
    const wall = getComputedStyle(canvas).getPropertyValue('--wall').trim()
    copy.fillStyle = wall
    const { data } = copy.getImageData(0, 0, canvas.width, canvas.height)
    copy.fillRect(0, 0, 1, 1)
    const [red, green, blue] = copy.getImageData(0, 0, 1, 1).data
    let same = 0
    for (let at = 0; at < data.length; at += 4) if (data[at] === red && data[at + 1] === green && data[at + 2] === blue) same += 1
    return same / (data.length / 4)
  })
  // The plot has a rim for its labels.
  expect(shaded).toBeGreaterThan(0.7 * share)
  expect(shaded).toBeLessThan(share)

  // A node that is pointed at here is where the arm stands there.
  await shot(lab)
  const stage = async (): Promise<string> => (await lab.stage.screenshot()).toString('base64')
  const resting = await stage()
  const box = await view.boundingBox()
  const [x = 0, y = 0] = [root[0], root[1]].map((angle = 0, axis) => {
    const { min, max } = (axis === 0 ? a : b) ?? { min: 0, max: 1 }
    return (angle - min) / (max - min)
  })
  await page.mouse.move(
    (box?.x ?? 0) + RIM.left + x * ((box?.width ?? 0) - RIM.left - RIM.right),
    (box?.y ?? 0) + (box?.height ?? 0) - RIM.bottom - y * ((box?.height ?? 0) - RIM.top - RIM.bottom),
  )
  await expect.poll(stage).not.toBe(resting)
  await page.mouse.move(0, 0)
  await expect.poll(stage).toBe(resting)

  // Another pair of joints is another picture.
  const picture = (): Promise<string> => view.evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL())
  await page.mouse.move(0, 0)
  const before = await picture()
  await page.getByTestId('joints-across').selectOption('3')
  await expect.poll(picture).not.toBe(before)
})

test('a tree in the plane: its nodes are drawn, named and picked', async ({ lab, page }) => {
  const setup = { planner: 'rrt', scene: 'wcpso-discs', seed: 2 }
  const k = 40
  await lab.open(linkTo(setup, k))
  expect(await lab.settled(k)).toBe(hashOf(setup, k))
  for (const role of ['tree', 'nodes']) await expect(page.getByTestId(`layer-${role}`)).toBeChecked()
  const node = sessionAt(setup, k, (session) => session.inspect({ role: 'nodes', index: 5 }))
  const [place] = node?.layers.find(({ role, shape }) => role === 'after' && shape === 'points')?.vertices ?? []
  if (!node || !place) throw new Error('no node')
  const { x, y } = await lab.whereIs(sceneOf(setup), [place[0], place[1]])
  await page.mouse.click(x, y)
  await expect(page.getByTestId('inspect').locator('h2')).toHaveText(node.title)
  const key = page.getByTestId('inspect-key')
  await expect(key).toContainText(closer.inspect.roles['nodes after'] ?? '')

  const whole = await lab.wholePicture()
  await lab.layer('tree', false)
  expect((await lab.picture()).digest).not.toBe(whole.digest)
})

test('the published cases of the arm are one choice away', async ({ lab, page }) => {
  await lab.open()
  for (const [name, planner, scene] of [
    ['rrt-guided.cuboid', 'rrt-guided', 'arm-cuboid'],
    ['rrt-joint.puma', 'rrt-joint', 'arm-puma'],
    ['rrt-joint.cuboid', 'rrt-joint', 'arm-cuboid'],
  ]) {
    await pick(page, 'case', name ?? '')
    await expect(page.getByTestId('planner')).toHaveAttribute('data-value', planner ?? '')
    await expect(page.getByTestId('scene')).toHaveAttribute('data-value', scene ?? '')
    await lab.restarted()
  }
  // There is no robot that drives.
  await expect(page.getByTestId('section-drive')).toHaveCount(0)
})

test('an arm’s scene is exported, opened again, and the same', async ({ lab, page }) => {
  await opened(lab)
  await page.getByRole('button', { name: en.bar.exports }).click()
  const [download] = await Promise.all([page.waitForEvent('download'), page.getByTestId('export-scene').click()])
  const file = await download.path()
  expect(armOf(JSON.parse(readFileSync(file, 'utf8')) as Scene)).toEqual(shipped)
  await page.keyboard.press('Escape')
  await pick(page, 'scene', 'arm-free')
  await lab.section('scene')
  await page.getByTestId('scene-file').setInputFiles({ name: 'arm.json', mimeType: 'application/json', buffer: readFileSync(file) })
  await expect(page.getByTestId('scene')).toHaveAttribute('data-value', 'arm-cuboid')
})

for (const colorScheme of ['light', 'dark'] as const) {
  test.describe(`in ${colorScheme} colours`, () => {
    test.use({ colorScheme, reducedMotion: 'reduce' })

    test('axe finds nothing wrong with the arm’s panels', async ({ lab }) => {
      await begin(lab, JOINTS)
      for (const id of ['result', 'joints', 'postures', 'survey', 'scene']) {
        await lab.section(id)
        if (id === 'postures') await expect(lab.page.getByTestId('postures').locator('tbody tr').first()).toBeVisible()
        expect(await violations(lab), id).toEqual([])
      }
    })
  })
}

test('on a phone nothing sticks out', async ({ lab, page }) => {
  await page.setViewportSize({ width: 390, height: 844 })
  await begin(lab, JOINTS)
  for (const id of ['result', 'joints', 'postures', 'survey', 'scene']) {
    await lab.section(id)
    if (id === 'postures') await expect(page.getByTestId('postures').locator('tbody tr').first()).toBeVisible()
    expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth), id).toBeLessThanOrEqual(0)
  }
})
