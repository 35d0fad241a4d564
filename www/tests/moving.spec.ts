import type { GridScene, Moving, Point, Scene, Session } from '../../pkg/node.js'
import { moving as text } from '../src/locales/en/moving'
import { placed } from '../src/scene/moving'
import { blamed } from '../src/scene/edits'
import { violations } from './support/axe'
import { hashOf, linkTo, sceneOf, sessionAt, verified } from './support/core'
import { en, expect, type Lab, test, pick } from './support/lab'

/** A planner that knows nothing of what moves: that is shown all the same. */
const PLAN = { planner: 'a-star', scene: 'wolf-ant-20' }
const AT = 6

function grid(scene: Scene): GridScene {
  if (scene.kind !== 'grid') throw new Error(scene.kind)
  return scene
}

const shipped = grid(sceneOf(PLAN))
const only: Moving = shipped.moving?.[0] ?? { center: [NaN, NaN], radius: NaN }
const RIGHT: Moving = { center: [210, 170], radius: 12, velocity: [50, 0] }
const WAYS: Moving = {
  center: [60, 260],
  radius: 10,
  waypoints: [
    [2, 100, 280],
    [5, 160, 320],
  ],
}

const withMoving = (moving: Moving[]): GridScene => {
  const { exact: _exact, published: _published, ...scene } = shipped
  return { ...scene, name: 'moving', title: 'What moves', moving }
}

async function begin(lab: Lab, scene: Scene | string = PLAN.scene, at = AT): Promise<string> {
  await lab.open(linkTo({ ...PLAN, scene }, at))
  const hash = await lab.settled(at)
  await expect(lab.page.getByTestId('add-moving')).toBeVisible()
  return hash
}

let asked = 0

/** The scene that the address tells, after a run that came back to where it was. Planned states are as they were, whatever moves:
 * only the address of one that nobody has asked for yet is new. */
async function edited(lab: Lab): Promise<GridScene> {
  asked += 1
  await lab.restarted()
  await lab.settled(AT)
  const { scene } = verified(await lab.link(await lab.seek(AT + asked)))
  await lab.seek(AT)
  return grid(scene)
}

const moving = async (lab: Lab): Promise<Moving[]> => (await edited(lab)).moving ?? []

async function drag(lab: Lab, from: Point, to: Point): Promise<void> {
  const [a, b] = [await lab.whereIs(shipped, from), await lab.whereIs(shipped, to)]
  await lab.dragFrom(a, b.x - a.x, b.y - a.y)
}

async function click(lab: Lab, at: Point): Promise<void> {
  const { x, y } = await lab.whereIs(shipped, at)
  await lab.page.mouse.click(x, y)
}

const ended = ({ center, velocity = [0, 0] }: Moving): Point => [center[0] + velocity[0], center[1] + velocity[1]]

test('an obstacle is added with a click and stands; the run comes back to where it was; undo and redo', async ({ lab, page }) => {
  const before = await begin(lab)
  await page.getByTestId('add-moving').click()
  await expect(page.getByText(text.adding)).toBeVisible()
  await click(lab, [250, 50])
  const added = await moving(lab)
  expect(added).toHaveLength(2)
  expect(added[0]).toEqual(only)
  expect(added[1]).toMatchObject({ radius: only.radius, velocity: [0, 0] })
  expect(added[1]?.center[0]).toBeCloseTo(250, 0)
  expect(added[1]?.center[1]).toBeCloseTo(50, 0)
  await expect(page.getByTestId('mover-card')).toContainText(text.name(2))

  await lab.press(en.bar.undo)
  expect(await moving(lab)).toEqual([only])
  expect(await lab.seek(AT)).toBe(before)
  await lab.press(en.bar.redo)
  expect(await moving(lab)).toEqual(added)
})

test('a press that is dragged adds one that moves: where the hand lets go it is after a second', async ({ lab, page }) => {
  await begin(lab)
  await page.getByTestId('add-moving').click()
  await drag(lab, [250, 50], [310, 50.4])
  const [, added] = await moving(lab)
  expect(added?.velocity?.[0]).toBeCloseTo(60, 0)
  expect(added?.velocity?.[1]).toBe(0)
  await expect(page.getByTestId('add-moving')).toHaveAttribute('aria-pressed', 'false')
})

test('it is dragged by its disc and aimed by its arrow; each drag is one edit', async ({ lab }) => {
  await begin(lab, withMoving([RIGHT]))
  await drag(lab, RIGHT.center, [230, 200])
  const [moved] = await moving(lab)
  expect(moved?.center[0]).toBeCloseTo(230, 0)
  expect(moved?.center[1]).toBeCloseTo(200, 0)
  expect(moved?.velocity).toEqual(RIGHT.velocity)
  if (!moved) throw new Error('gone')

  await drag(lab, ended(moved), [260, 160])
  const [aimed] = await moving(lab)
  expect(aimed?.center).toEqual(moved.center)
  expect(aimed?.velocity?.[0]).toBeCloseTo(30, 0)
  expect(aimed?.velocity?.[1]).toBeCloseTo(-40, 0)

  await lab.press(en.bar.undo)
  expect(await moving(lab)).toEqual([moved])
  await lab.press(en.bar.undo)
  expect(await moving(lab)).toEqual([RIGHT])
})

test('with keys alone one is reached, moved, aimed and deleted, and each is told', async ({ lab, page }) => {
  await begin(lab, withMoving([only, RIGHT]))
  await lab.stage.focus()
  await page.keyboard.press('Tab')
  await page.keyboard.press('Tab')
  await expect(page.getByTestId('mover-1')).toBeFocused()
  const told = page.getByTestId('mover-told')
  await expect(told).toHaveText(text.told(text.name(2), 2, '210', '170', '12', text.goes('50', '0')))

  // A quarter of a cell a press; y grows downwards here.
  await page.keyboard.press('ArrowRight')
  await page.keyboard.press('ArrowDown')
  await page.keyboard.press('Shift+ArrowUp')
  await page.keyboard.press('Shift+ArrowUp')
  await expect(told).toHaveText(text.told(text.name(2), 2, '215', '175', '12', text.goes('50', '−10')))
  expect((await moving(lab))[1]).toEqual({ ...RIGHT, center: [215, 175], velocity: [50, -10] })
  // A row of presses is one edit.
  await page.keyboard.press('ControlOrMeta+z')
  expect(await moving(lab)).toEqual([only, RIGHT])

  await page.getByTestId('mover-0').focus()
  await page.keyboard.press('Delete')
  await expect(page.getByTestId('mover-0')).toBeFocused()
  await expect(told).toContainText('210')
  expect(await moving(lab)).toEqual([RIGHT])
  await page.getByTestId('mover-0').focus()
  await page.keyboard.press('Delete')
  await expect(lab.stage).toBeFocused()
  await expect(told).toHaveText(text.gone(0))
  expect(await moving(lab)).toEqual([])
})

test('numbers are typed in the list; what the core refuses is said beside the field', async ({ lab, page }) => {
  await begin(lab)
  await lab.section('scene')
  const name = text.name(1)
  const set = async (field: keyof typeof text.spoken, value: string): Promise<void> => {
    const cell = page.getByTestId('moving').getByLabel(text.field(name, text.spoken[field]), { exact: true })
    await cell.fill(value)
    await cell.press('Enter')
  }
  await set('x', '140.5')
  await set('vx', '−7.5')
  await set('radius', '8')
  expect(await moving(lab)).toEqual([{ center: [140.5, 145], radius: 8, velocity: [-7.5, -20] }])

  await set('radius', '-2')
  await expect(page.getByTestId('moving-error')).toContainText('moving[0].radius')
  await expect(page.getByTestId('moving').getByLabel(text.field(name, text.spoken.radius), { exact: true })).toHaveAttribute(
    'aria-invalid',
    'true',
  )
  await expect(page.getByTestId('moving').getByLabel(text.field(name, text.spoken.x), { exact: true })).toHaveAttribute(
    'aria-invalid',
    'false',
  )
  await set('radius', '3')
  await expect(page.getByTestId('moving-error')).toHaveCount(0)
  expect((await moving(lab))[0]?.radius).toBe(3)

  await set('vy', 'fast')
  await expect(page.getByText(en.scene.notNumber('fast'))).toBeVisible()
  expect(blamed('moving[3].velocity[1]')).toEqual({ kind: 'moving', index: 3 })
})

test('the list adds and removes; the card on the stage changes the radius', async ({ lab, page }) => {
  await begin(lab)
  await lab.section('scene')
  await page.getByTestId('list-add-moving').click()
  await page.getByTestId('list-add-moving').click()
  const three = await moving(lab)
  expect(three).toHaveLength(3)
  expect(three[1]?.center).not.toEqual(three[2]?.center)

  const radius = page.getByTestId('mover-card').getByLabel(text.field(text.name(3), text.spoken.radius), { exact: true })
  await radius.fill('9')
  await radius.press('Enter')
  expect((await moving(lab))[2]?.radius).toBe(9)
  await page.getByTestId('remove-moving').click()
  await page
    .getByTestId('moving')
    .getByRole('button', { name: text.remove(text.name(1)), exact: true })
    .click()
  expect(await moving(lab)).toEqual(three.slice(1, 2))
})

test('the scene’s robot has fields; an empty one is left to the planner', async ({ lab, page }) => {
  await begin(lab)
  await lab.section('scene')
  const set = async (field: 'sensor' | 'turn_time', value: string): Promise<void> => {
    const cell = page.getByLabel(text.field(text.robot.title, text.robot[field]), { exact: true })
    await cell.fill(value)
    await cell.press('Enter')
    await lab.restarted()
  }
  const robot = async (at: number): Promise<GridScene['robot']> => grid(verified(await lab.link(await lab.seek(at))).scene).robot
  await set('sensor', '90')
  expect(await robot(2)).toEqual({ ...shipped.robot, sensor: 90 })
  await set('turn_time', '')
  expect(await robot(3)).toEqual({ speed: 20, sensor: 90 })
  await page.getByLabel(text.field(text.robot.title, text.robot.sensor), { exact: true }).fill('0')
  await page.keyboard.press('Enter')
  await expect(page.getByTestId('robot-error')).toContainText('robot.sensor')
})

test('one that goes from way-point to way-point keeps to them when it is dragged, until it is told to go straight on', async ({
  lab,
  page,
}) => {
  await begin(lab, withMoving([WAYS]))
  await drag(lab, WAYS.center, [80, 280])
  const [moved] = await moving(lab)
  const shift: Point = [(moved?.center[0] ?? NaN) - 60, (moved?.center[1] ?? NaN) - 260]
  expect(shift[0]).toBeCloseTo(20, 0)
  expect(moved).toEqual(placed(WAYS, ([x, y]) => [x + shift[0], y + shift[1]]))
  await page.getByTestId('straighten').click()
  expect(await moving(lab)).toEqual([{ center: moved?.center, radius: 10, velocity: [20, 10] }])
})

test('obstacles are drawn with every planner, and put away with the legend', async ({ lab, page }) => {
  await begin(lab, withMoving([RIGHT, WAYS]))
  const whole = await lab.wholePicture()
  await lab.layer('moving', false)
  const without = await lab.wholePicture()
  expect(without.digest).not.toBe(whole.digest)
  await lab.layer('moving', true)
  expect((await lab.wholePicture()).digest).toBe(whole.digest)
  await pick(page, 'planner', 'theta-star')
  await lab.seek(AT)
  await expect(page.getByTestId('layer-moving')).toBeChecked()
})

test('a planner that knows nothing of them finds the same way', async ({ lab }) => {
  await begin(lab, withMoving([RIGHT]))
  await drag(lab, RIGHT.center, [100, 100])
  const scene = await edited(lab)
  expect(scene.moving).not.toEqual([RIGHT])
  expect(await lab.settled(AT)).toBe(hashOf({ ...PLAN, scene }, AT))
})

const DRIVE = 'd-star-lite-drive'
/** While the robot is on its way. */
const UNDERWAY = 60

/** The page at a moment of a drive. */
async function drive(lab: Lab, scene: GridScene): Promise<string> {
  await lab.open(linkTo({ planner: DRIVE, scene }, UNDERWAY))
  return lab.settled(UNDERWAY)
}

const told = <T>(scene: GridScene, ask: (session: Session) => T): T => sessionAt({ planner: DRIVE, scene }, UNDERWAY, ask)

test('an obstacle that is dropped into a drive leaves the moment as it is, and the drive goes on with it', async ({ lab, page }) => {
  const scene = withMoving([RIGHT])
  await drive(lab, scene)
  await page.getByTestId('add-moving').click()
  await expect(page.getByText(text.addingLater)).toBeVisible()
  await click(lab, [230, 290])
  await lab.restarted()
  await lab.settled(UNDERWAY)
  const link = verified(await lab.link(await lab.seek(UNDERWAY + 1)))
  expect(grid(link.scene).moving).toHaveLength(2)
  expect(await lab.settled()).toBe(hashOf({ planner: DRIVE, scene: link.scene }, UNDERWAY + 1))
  await lab.press(en.bar.undo)
  await lab.restarted()
  expect(await lab.settled(UNDERWAY)).toBe(hashOf({ planner: DRIVE, scene }, UNDERWAY))
})

test('while a drive stands still, an obstacle is dragged from where it is now, and is asked about', async ({ lab, page }) => {
  const slow: Moving = { center: [300, 60], radius: 12, velocity: [0, 5] }
  const scene = withMoving([slow])
  await drive(lab, scene)
  const seconds = told(scene, (session) => session.readings().time ?? NaN)
  expect(seconds).toBeGreaterThan(4)
  const now: Point = [300, 60 + 5 * seconds]
  await click(lab, now)
  await expect(page.getByTestId('inspect').getByRole('heading', { level: 2 })).toHaveText(
    told(scene, (session) => session.inspect({ role: 'moving', index: 0 })?.title ?? ''),
  )
  await drag(lab, now, [now[0] - 40, now[1]])
  await lab.restarted()
  await lab.settled(UNDERWAY)
  const { scene: edited } = verified(await lab.link(await lab.seek(UNDERWAY + 1)))
  const [moved] = grid(edited).moving ?? []
  expect(moved?.center[0]).toBeCloseTo(260, 0)
  expect(moved?.center[1]).toBeCloseTo(60, 0)
})

test('while a drive goes on, its obstacles can’t be caught; when it stands they can be chosen', async ({ lab, page }) => {
  const scene = withMoving([{ center: [300, 60], radius: 14, velocity: [0, 0] }])
  await drive(lab, scene)
  await lab.press(en.transport.play)
  await drag(lab, [300, 60], [250, 60])
  await lab.press(en.transport.pause)
  expect(grid(verified(await lab.link(await lab.settled())).scene).moving).toEqual(scene.moving)
  await lab.press(en.stage.fit)
  await click(lab, [300, 60])
  await expect(page.getByTestId('mover-card')).toBeVisible()
})

test('a mark of an event tells what happened there and why', async ({ lab, page }) => {
  const scene = withMoving([{ center: [230, 250], radius: 14, velocity: [-12, -12] }])
  await drive(lab, scene)
  const events = told(scene, (session) => session.outcome().events) ?? []
  const index = events.findLastIndex(({ place: [x, y] }) => Math.hypot(x - 30, y - 30) > 30)
  const event = events[index]
  if (!event) throw new Error('nothing happened')
  await click(lab, event.place)
  await expect(page.getByTestId('inspect')).toContainText(event.reason)
})

test('what drives is drawn in layers that can be put away', async ({ lab }) => {
  await drive(lab, withMoving([RIGHT, { center: [130, 200], radius: 10, velocity: [0, -3] }]))
  const whole = await lab.wholePicture()
  for (const role of ['robot', 'sensor', 'track', 'ahead', 'predicted', 'moving', 'events']) {
    await lab.layer(role, false)
    expect((await lab.wholePicture()).digest, role).not.toBe(whole.digest)
    await lab.layer(role, true)
  }
  expect((await lab.wholePicture()).digest).toBe(whole.digest)
})

const screens = { desktop: { width: 1440, height: 900 }, phone: { width: 390, height: 844 } }

for (const colorScheme of ['light', 'dark'] as const) {
  for (const [screen, viewport] of Object.entries(screens)) {
    test.describe(`${screen}, ${colorScheme}`, () => {
      test.use({ colorScheme, viewport, hasTouch: screen === 'phone' })

      test('axe finds nothing wrong with what moves; nothing is too wide', async ({ lab, page }) => {
        await begin(lab, withMoving([only, RIGHT, WAYS]))
        await lab.section('scene')
        await page.getByTestId('mover-2').focus()
        await expect(page.getByTestId('straighten')).toBeVisible()
        expect(await violations(lab)).toEqual([])
        expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(viewport.width)
      })
    })
  }
}

test.describe('on a phone', () => {
  test.use({ viewport: screens.phone, hasTouch: true, isMobile: true })

  test('a finger chooses one and pulls its arrow', async ({ lab, page }) => {
    await begin(lab, withMoving([RIGHT]))
    const at = await lab.whereIs(shipped, RIGHT.center)
    await page.touchscreen.tap(at.x, at.y)
    await expect(page.getByTestId('mover-card')).toBeVisible()
    const [from, to] = [await lab.whereIs(shipped, ended(RIGHT)), await lab.whereIs(shipped, [260, 220])]
    const finger = await page.context().newCDPSession(page)
    await finger.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: [from] })
    for (let part = 0.2; part < 1.1; part += 0.2) {
      await finger.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: [{ x: from.x, y: from.y + part * (to.y - from.y) }] })
    }
    await finger.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] })
    const [aimed] = await moving(lab)
    expect(aimed?.center).toEqual(RIGHT.center)
    expect(aimed?.velocity?.[0]).toBe(50)
    expect(aimed?.velocity?.[1]).toBeCloseTo(50, -1)
  })
})
