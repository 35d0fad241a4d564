import { readFile } from 'node:fs/promises'
import type { Page } from '@playwright/test'
import type { ArmScene, Point3 } from '../../pkg/node.js'
import { arm as words } from '../src/locales/en/arm'
import { space as text } from '../src/locales/en/space'
import { LIFT } from '../src/render/space/handles'
import { middle } from '../src/scene/arm'
import { violations } from './support/axe'
import { hashOf, layerOf, linkTo, sceneOf, sessionAt, verified } from './support/core'
import { en, expect, type Lab, test, pick } from './support/lab'
import { armOf, seenAt, shot } from './support/space'

/** A path around the cuboid is found on the way. */
const GUIDED = { planner: 'rrt-guided', scene: 'arm-cuboid', seed: 1 }
const AT = sessionAt(GUIDED, 1000, (session) => session.iteration)
const scene = armOf(sceneOf(GUIDED))
const cuboid = scene.cuboids[0] ?? { min: [0, 0, 0], max: [0, 0, 0] }
const top: Point3 = [...middle(cuboid)]
top[2] = cuboid.max[2]

const from = (at: Point3, dx: number, dy: number, dz = 0): Point3 => [at[0] + dx, at[1] + dy, at[2] + dz]

async function begin(lab: Lab, at = AT): Promise<string> {
  // What is flown over can't be compared.
  await lab.page.emulateMedia({ reducedMotion: 'reduce' })
  await lab.open(linkTo(GUIDED, at))
  const hash = await lab.settled(at)
  await expect(lab.stage).toBeVisible()
  return hash
}

/** The scene that the address tells, once the run stands at `iteration`. */
async function sceneAt(lab: Lab, iteration: number): Promise<ArmScene> {
  return armOf(verified(await lab.link(await lab.seek(iteration))).scene)
}

async function drag(lab: Lab, a: Point3, b: Point3, across = false): Promise<void> {
  const [begins, ends] = [await seenAt(lab, scene, a), await seenAt(lab, scene, b)]
  const { keyboard, mouse } = lab.page
  await mouse.move(begins.x, begins.y)
  await mouse.down()
  if (across) await keyboard.down('Shift')
  await mouse.move((begins.x + ends.x) / 2, (begins.y + ends.y) / 2, { steps: 3 })
  await mouse.move(ends.x, ends.y, { steps: 3 })
  await mouse.up()
  if (across) await keyboard.up('Shift')
}

const near = (found: readonly number[] | undefined, expected: readonly number[], within = 0.004): void => {
  expect(found).toHaveLength(expected.length)
  for (const [axis, value] of expected.entries()) expect(Math.abs((found?.[axis] ?? NaN) - value)).toBeLessThan(within)
}

/** Where the tree's nodes are. */
const nodes = (iteration: number): Point3[] =>
  sessionAt(GUIDED, iteration, (session) => {
    const role = layerOf(session, 'nodes')
    const { vertices, spans } = session.frame(1e6)
    const found: Point3[] = []
    for (let span = 0; span < spans.length; span += 4) {
      const [of = -1, , first = 0, count = 0] = spans.subarray(span, span + 4)
      for (let at = 4 * first; of === role && at < 4 * (first + count); at += 4)
        found.push([vertices[at] ?? NaN, vertices[at + 1] ?? NaN, vertices[at + 2] ?? NaN])
    }
    return found
  })

for (const colorScheme of ['light', 'dark'] as const) {
  test.describe(colorScheme, () => {
    test.use({ colorScheme })

    test('the stage in space isn’t blank, and each layer makes a difference', { tag: colorScheme === 'light' ? ['@smoke'] : [] }, async ({
      lab,
    }) => {
      await begin(lab)
      const pictures = [await shot(lab)]
      expect(pictures[0]?.colours).toBeGreaterThan(1000)
      for (const role of ['tree', 'nodes', 'smoothed', 'best', 'exact', 'arm']) {
        await lab.layer(role, false)
        pictures.push(await shot(lab))
      }
      expect(new Set(pictures.map(({ digest }) => digest)).size).toBe(7)
    })

    test('axe finds nothing wrong with the stage in space, with a cuboid and a node chosen', {
      tag: colorScheme === 'light' ? ['@smoke'] : [],
    }, async ({ lab, page }) => {
      await begin(lab)
      await lab.stage.focus()
      for (const key of ['k', 'n', 'n', 'n']) await page.keyboard.press(key)
      await expect(page.getByTestId('space-selected')).toHaveText(/cuboid 1/)
      expect(await violations(lab)).toEqual([])
    })
  })
}

test('the tree grows on the stage as the run steps, and words tell it', async ({ lab, page }) => {
  await begin(lab, 20)
  const before = await shot(lab)
  await expect(page.getByTestId('space-words')).toContainText('There is no path yet')
  await lab.seek(60)
  expect((await shot(lab)).digest).not.toBe(before.digest)
  await lab.seek(20)
  expect(await shot(lab)).toEqual(before)
  await lab.seek(AT)
  await expect(page.getByTestId('space-words')).toContainText(`The tree has ${nodes(AT).length} nodes. A path of 1.3`)
})

test('keys turn and zoom the view and show it from each side; 0 shows all again', async ({ lab, page }) => {
  await begin(lab)
  await lab.stage.focus()
  const whole = await shot(lab)
  await page.keyboard.press('ArrowLeft')
  const turned = await shot(lab)
  expect(turned.digest).not.toBe(whole.digest)
  await page.keyboard.press('ArrowRight')
  expect(await shot(lab)).toEqual(whole)
  const seen = new Set([whole.digest, turned.digest])
  for (const key of ['+', '1', '2', '3']) {
    await page.keyboard.press(key)
    seen.add((await shot(lab)).digest)
  }
  expect(seen.size).toBe(6)
  await page.keyboard.press('4')
  expect(await shot(lab)).toEqual(whole)
  expect(await lab.settled(AT)).toBe(hashOf(GUIDED, AT))
})

test('the pointer turns the view, the wheel zooms, the right button moves it; the scene stays', async ({ lab, page }) => {
  const hash = await begin(lab)
  const seen = new Set([(await shot(lab)).digest])
  const free = await seenAt(lab, scene, [1.1, 0, 0])
  await lab.dragFrom(free, 80, 20)
  seen.add((await shot(lab)).digest)
  await page.mouse.move(free.x, free.y)
  await page.mouse.wheel(0, -300)
  await page.mouse.down({ button: 'right' })
  await page.mouse.move(free.x - 60, free.y)
  await page.mouse.up({ button: 'right' })
  seen.add((await shot(lab)).digest)
  expect(seen.size).toBe(3)
  expect(await lab.settled(AT)).toBe(hash)
  for (const side of ['front', 'side', 'top', 'corner']) {
    await page.getByTestId(`view-${side}`).click()
    seen.add((await shot(lab)).digest)
  }
  expect(seen.size).toBe(6)
})

test('the arm moves with the time of its motion, and stands at home again afterwards', async ({ lab, page }) => {
  await begin(lab)
  const still = await shot(lab)
  await lab.section('motion')
  await lab.press(words.motion.begin)
  await expect(page.getByRole('slider', { name: words.motion.scrubber })).toBeVisible()
  const first = await shot(lab)
  expect(first.digest).not.toBe(still.digest)
  await lab.stage.focus()
  await page.keyboard.press('End')
  const last = await shot(lab)
  expect(last.digest).not.toBe(first.digest)
  await page.keyboard.press('Home')
  await lab.stage.blur()
  expect(await shot(lab)).toEqual(first)
  await lab.stage.focus()
  await page.keyboard.press('Escape')
  await lab.stage.blur()
  expect(await shot(lab)).toEqual(still)
})

test('the postures of the goal are ghosts, and where the tip can come is a cloud', async ({ lab }) => {
  await begin(lab)
  const alone = await shot(lab)
  const postures = await lab.section('postures')
  await expect(postures.getByRole('row')).not.toHaveCount(0)
  const ghosts = await shot(lab)
  expect(ghosts.digest).not.toBe(alone.digest)
  await postures.locator('> summary').click()
  expect(await shot(lab)).toEqual(alone)

  await lab.section('survey')
  await lab.press(words.survey.show)
  await expect(lab.button(words.survey.clear)).toBeVisible()
  expect((await shot(lab)).digest).not.toBe(alone.digest)
  await lab.press(words.survey.clear)
  expect(await shot(lab)).toEqual(alone)
})

test('a still picture is drawn once', async ({ lab, page }) => {
  await drawnByThePage(page)
  await page.addInitScript(() => {
    Object.assign(window, { drawn: 0 })
    const { prototype } = WebGL2RenderingContext
    const { drawElements } = prototype
    prototype.drawElements = function (...given: Parameters<typeof drawElements>) {
      Object.assign(window, { drawn: (window as unknown as { drawn: number }).drawn + 1 })
      drawElements.apply(this, given)
    }
  })
  await begin(lab)
  await shot(lab)
  const count = (): Promise<number> => page.evaluate(() => (window as unknown as { drawn: number }).drawn)
  const before = await count()
  expect(before).toBeGreaterThan(0)
  await page.evaluate(async () => {
    for (let frames = 0; frames < 30; frames += 1) await new Promise(requestAnimationFrame)
  })
  expect(await count()).toBe(before)
})

test('a click on a node tells how it came about; keys go to its neighbours', async ({ lab, page }) => {
  await begin(lab)
  await lab.section('inspect')
  // The samples of the last extension would lie among them.
  await lab.layer('samples', false)
  const all = nodes(AT)
  const places = await Promise.all(all.map((at) => seenAt(lab, scene, at)))
  const marks = await Promise.all([scene.start, scene.goal].map((at) => seenAt(lab, scene, at)))
  const alone = ({ x, y }: { x: number; y: number }): number =>
    Math.min(
      ...[...places, ...marks].filter((other) => other.x !== x || other.y !== y).map((other) => Math.hypot(other.x - x, other.y - y)),
    )
  // Before the cuboid, where nothing hides it.
  const front = all.map((at, index) => ({ index, at })).filter(({ at }) => at[1] < 0.15 && at[0] < 0.2)
  const index = front.reduce(
    (best, one) => (alone(places[one.index] ?? { x: 0, y: 0 }) > alone(places[best] ?? { x: 0, y: 0 }) ? one.index : best),
    front[0]?.index ?? 0,
  )
  const at = places[index] ?? { x: 0, y: 0 }
  await page.mouse.click(at.x, at.y)
  const panel = page.getByTestId('section-inspect')
  const titled = (number: number): string =>
    sessionAt(GUIDED, AT, (session) => session.inspect({ role: 'nodes', index: number })?.title ?? '')
  await expect(panel.getByText(titled(index), { exact: true })).toBeVisible()
  await lab.stage.focus()
  for (const key of ['k', 'k', 'j', 'k']) await page.keyboard.press(key)
  await expect(panel.getByText(titled(index + 2), { exact: true })).toBeVisible()
  await page.keyboard.press('Escape')
  await expect(panel.getByText(titled(index + 2), { exact: true })).toBeHidden()
})

test('a cuboid is dragged over the floor; undo brings it back', async ({ lab }) => {
  const before = await begin(lab)
  await drag(lab, top, from(top, 0.15, -0.1))
  const edited = await sceneAt(lab, 13)
  near(edited.cuboids[0]?.min, from(cuboid.min, 0.15, -0.1))
  near(edited.cuboids[0]?.max, from(cuboid.max, 0.15, -0.1))
  expect([edited.exact, edited.published]).toEqual([undefined, undefined])
  expect(await lab.settled(13)).toBe(hashOf({ ...GUIDED, scene: edited }, 13))
  await lab.press(en.bar.undo)
  expect(await lab.seek(AT)).toBe(before)
})

test('with Shift a drag lifts, start and goal too', async ({ lab }) => {
  await begin(lab)
  await drag(lab, scene.goal, from(scene.goal, 0, 0, 0.2), true)
  near((await sceneAt(lab, 2)).goal, from(scene.goal, 0, 0, 0.2))
  await drag(lab, scene.start, from(scene.start, 0.1, 0.1))
  near((await sceneAt(lab, 3)).start, from(scene.start, 0.1, 0.1))
  await drag(lab, top, from(top, 0, 0, 0.1), true)
  const lifted = (await sceneAt(lab, 4)).cuboids[0]
  near([lifted?.min[2] ?? NaN, lifted?.max[2] ?? NaN], [0.1, cuboid.max[2] + 0.1])
})

test('a chosen cuboid’s faces are dragged, and the arrow above it lifts it; a chosen base is moved', async ({ lab, page }) => {
  await begin(lab)
  const body = await seenAt(lab, scene, top)
  await page.mouse.click(body.x + 12, body.y + 8)
  await expect(page.getByTestId('space-selected')).toHaveText(/^cuboid 1/)
  const right: Point3 = [...middle(cuboid)]
  right[0] = cuboid.max[0]
  await drag(lab, right, from(right, 0.2, 0))
  const wider = (await sceneAt(lab, 2)).cuboids[0]
  near(wider?.max, from(cuboid.max, 0.2, 0))
  expect(wider?.min).toEqual(cuboid.min)

  // The arrow stands so far above the top.
  const arrow = await seenAt(lab, scene, from(top, 0.1, 0))
  await lab.dragFrom({ x: arrow.x, y: arrow.y - LIFT }, 0, -40)
  const lifted = (await sceneAt(lab, 3)).cuboids[0]
  expect(lifted?.min[2]).toBeGreaterThan(0.05)
  near([lifted?.max[0] ?? NaN, lifted?.max[1] ?? NaN], [wider?.max[0] ?? NaN, wider?.max[1] ?? NaN], 1e-9)

  // It hides nothing of the column where it was.
  await lab.press(en.bar.undo)
  const { arm } = scene
  const [x, y] = arm.base.position
  const foot: Point3 = [x, y - (arm.base.column_radius ?? 0), 0.36]
  const column = await seenAt(lab, scene, foot)
  await page.mouse.click(column.x, column.y)
  await expect(page.getByTestId('space-selected')).toHaveText(/^base/)
  await drag(lab, foot, from(foot, -0.1, 0))
  near((await sceneAt(lab, 4)).arm.base.position, from(arm.base.position, -0.1, 0), 0.01)
})

test('the scene is edited with the keyboard alone', async ({ lab, page }) => {
  await begin(lab)
  await lab.stage.focus()
  for (const name of ['start', 'goal', 'cuboid 1', 'base', 'start']) {
    await page.keyboard.press('n')
    await expect(page.getByTestId('space-selected')).toHaveText(new RegExp(`^${name}`))
  }
  for (const key of ['Shift+N', 'Shift+N', 'ArrowRight', 'ArrowUp', 'PageUp']) await page.keyboard.press(key)
  const moved = (await sceneAt(lab, 2)).cuboids[0]
  near(moved?.min, from(cuboid.min, 0.01, 0.01, 0.01), 1e-9)
  near(moved?.max, from(cuboid.max, 0.01, 0.01, 0.01), 1e-9)

  await lab.stage.focus()
  for (const key of ['Shift+ArrowRight', 'Shift+ArrowUp', 'Shift+PageDown']) await page.keyboard.press(key)
  const sized = (await sceneAt(lab, 3)).cuboids[0]
  near(sized?.max, from(cuboid.max, 0.02, 0.02, 0), 1e-9)
  expect(sized?.min).toEqual(moved?.min)

  await lab.stage.focus()
  await page.keyboard.press('Delete')
  expect((await sceneAt(lab, 4)).cuboids).toEqual([])
  await page.keyboard.press('ControlOrMeta+z')
  expect((await sceneAt(lab, 5)).cuboids).toEqual([sized])
  await lab.stage.focus()
  await page.keyboard.press('a')
  expect((await sceneAt(lab, 6)).cuboids).toHaveLength(2)
  await lab.stage.focus()
  await page.keyboard.press('Escape')
  await expect(page.getByTestId('space-selected')).toHaveText('')
})

test('cuboids are added and deleted with the tools', async ({ lab, page }) => {
  await begin(lab)
  await expect(page.getByTestId('remove-cuboid')).toBeDisabled()
  await page.getByTestId('add-cuboid').click()
  const two = await sceneAt(lab, 2)
  expect(two.cuboids).toHaveLength(2)
  await page.getByTestId('remove-cuboid').click()
  expect((await sceneAt(lab, 3)).cuboids).toEqual(scene.cuboids)
})

test('a goal within a cuboid is refused where it is seen, and the old run doesn’t pass for the new', async ({ lab, page }) => {
  await begin(lab)
  const before = await shot(lab)
  await drag(lab, top, from(scene.goal, 0, 0, cuboid.max[2] - scene.goal[2]))
  await expect(page.locator('main').getByRole('alert')).toContainText('goal')
  expect((await shot(lab)).digest).not.toBe(before.digest)
  await lab.press(en.bar.undo)
  await lab.seek(AT)
  await expect(page.locator('main').getByRole('alert')).toBeHidden()
})

test('the picture that is exported is that of the stage', async ({ lab, page }) => {
  await begin(lab)
  await lab.press(en.bar.exports)
  const started = page.waitForEvent('download')
  await page.getByTestId('export-png').click()
  const content = (await readFile(await (await started).path())).toString('base64')
  const colours = await page.evaluate(async (png) => {
    const bytes = Uint8Array.from(atob(png), (letter) => letter.charCodeAt(0))
    const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }))
    const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d')
    context?.drawImage(bitmap, 0, 0)
    return new Set(new Uint32Array(context?.getImageData(0, 0, bitmap.width, bitmap.height).data.buffer ?? new ArrayBuffer(0))).size
  }, content)
  expect(colours).toBeGreaterThan(1000)
})

test('another kind of scene has its own stage, and space comes back as it was', { tag: '@smoke' }, async ({ lab, page }) => {
  await begin(lab)
  const before = await shot(lab)
  await pick(page, 'planner', 'pso')
  await expect(page.getByTestId('space-words')).toHaveCount(0)
  await lab.restarted()
  expect((await lab.picture()).colours).toBeGreaterThan(100)
  await lab.open(linkTo(GUIDED, AT))
  await lab.settled(AT)
  expect(await shot(lab)).toEqual(before)
})

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true })

  test('a finger turns the view, a tap chooses, and what is chosen is carried; nothing is too wide', async ({ lab, page }) => {
    const hash = await begin(lab)
    const seen = new Set([(await shot(lab)).digest])
    const at = await seenAt(lab, scene, top)
    const touch = await page.context().newCDPSession(page)
    const finger = (type: 'touchStart' | 'touchMove' | 'touchEnd', x: number, y: number) =>
      touch.send('Input.dispatchTouchEvent', { type, touchPoints: type === 'touchEnd' ? [] : [{ x, y }] })
    const swipe = async (dx: number, dy: number): Promise<void> => {
      await finger('touchStart', at.x, at.y)
      for (const share of [0.25, 0.5, 0.75, 1]) await finger('touchMove', at.x + share * dx, at.y + share * dy)
      await finger('touchEnd', 0, 0)
    }
    // It lands on the cuboid, and yet turns the view.
    await swipe(30, 0)
    seen.add((await shot(lab)).digest)
    expect(seen.size).toBe(2)
    expect(await lab.settled(AT)).toBe(hash)

    await page.getByTestId('view-corner').click()
    await lab.layer('nodes', false)
    await lab.layer('samples', false)
    await page.getByTestId('fold-legend').click()
    await page.touchscreen.tap(at.x, at.y)
    await expect(page.getByTestId('space-selected')).toHaveText(/^cuboid 1/)
    // Beside the dots that move its faces.
    const body = await seenAt(lab, scene, from(cuboid.min, 0.02, 0, 0.02))
    at.x = body.x
    at.y = body.y
    await swipe(30, 0)
    expect((await sceneAt(lab, 2)).cuboids[0]?.min[0]).toBeGreaterThan(cuboid.min[0] + 0.05)
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390)
    expect(await violations(lab)).toEqual([])
  })
})

interface OnPage {
  space?: WebGL2RenderingContext
  lost?: WEBGL_lose_context
}

/** No thread draws; `able`: space is drawn at all. */
const drawnByThePage = (page: Page, able = true): Promise<unknown> =>
  page.addInitScript((draws) => {
    Reflect.deleteProperty(HTMLCanvasElement.prototype, 'transferControlToOffscreen')
    const { prototype } = HTMLCanvasElement
    const { getContext } = prototype
    Object.assign(prototype, {
      getContext(this: HTMLCanvasElement, kind: string, ...options: unknown[]) {
        if (!kind.startsWith('webgl')) return Reflect.apply(getContext, this, [kind, ...options])
        if (!draws) return null
        const space = Reflect.apply(getContext, this, [kind, ...options])
        Object.assign(window, { space, lost: space?.getExtension('WEBGL_lose_context') })
        return space
      },
    })
  }, able)

test('when the graphics card drops the picture, the stage says so, and it comes back', async ({ lab, page }) => {
  await drawnByThePage(page)
  await begin(lab)
  const before = await shot(lab)
  await page.evaluate(() => (window as unknown as OnPage).space?.getExtension('WEBGL_lose_context')?.loseContext())
  await expect(page.getByText(text.lost)).toBeVisible()
  await page.evaluate(() => (window as unknown as OnPage).lost?.restoreContext())
  await expect(page.getByText(text.lost)).toBeHidden()
  expect(await shot(lab)).toEqual(before)
})

test('without WebGL the stage says so, and the rest goes on', async ({ lab, page }) => {
  await drawnByThePage(page, false)
  await lab.open(linkTo(GUIDED, 20))
  await lab.settled(20)
  await expect(page.getByTestId('no-space')).toContainText(text.failed)
  await expect(lab.stage).toBeHidden()
  expect(await lab.seek(AT)).toBe(hashOf(GUIDED, AT))
  await expect(page.getByTestId('no-space')).toContainText('A path of')
  expect(await violations(lab)).toEqual([])
})
