import type { DiscsScene, Point, Scene } from '../../pkg/node.js'
import { forks } from '../src/locales/en/forks'
import { panels } from '../src/locales/en/panels'
import { number } from '../src/text/number'
import { hashOf, linkTo, outcomeOf, sceneOf, trialOf, verified } from './support/core'
import { en, expect, HASH, type Lab, test, pick } from './support/lab'

function discs(scene: Scene): DiscsScene {
  if (scene.kind !== 'discs') throw new Error(scene.kind)
  return scene
}

const shipped = discs(sceneOf({}))
const center = (index: number, of = shipped): Point => of.discs[index]?.center ?? [NaN, NaN]

/** The scene that the address tells, once the run stands at `iteration`. */
async function sceneAt(lab: Lab, iteration: number): Promise<DiscsScene> {
  const hash = await lab.seek(iteration)
  return discs(verified(await lab.link(hash)).scene)
}

test('dragging a disc restarts the run on the edited scene; undo and redo restore it', { tag: '@smoke' }, async ({ lab }) => {
  await lab.open(linkTo({}, 60))
  const before = await lab.settled(60)
  await lab.dragFrom(await lab.whereIs(shipped, center(0)), 90, -40)
  // It stands where it stood, on the other scene.
  await lab.restarted()
  expect(await lab.settled(60)).not.toBe(before)

  const edited = await sceneAt(lab, 20)
  expect(center(0, edited)[0]).toBeGreaterThan(center(0)[0] + 0.3)
  expect(center(0, edited)[1]).toBeGreaterThan(center(0)[1] + 0.1)
  expect(edited.discs.slice(1)).toEqual(shipped.discs.slice(1))
  expect(hashOf({ scene: edited }, 20)).toBe(await lab.settled(20))

  await lab.press(en.bar.undo)
  expect(await lab.settled(60)).toBe(before)
  await lab.press(en.bar.redo)
  expect(await lab.settled(20)).toBe(hashOf({ scene: edited }, 20))
  expect(await sceneAt(lab, 20)).toEqual(edited)
})

test('while a disc is dragged, no picture of the old scene stays', async ({ lab, page }) => {
  await lab.open(linkTo({}, 100))
  const old = await lab.settled(100)
  const from = await lab.whereIs(shipped, center(2))
  await page.mouse.move(from.x, from.y)
  await page.mouse.down()
  await page.mouse.move(from.x + 40, from.y + 40, { steps: 4 })
  await expect(lab.root).toHaveAttribute('data-hash', HASH)
  await expect(lab.root).not.toHaveAttribute('data-hash', old)
  await page.mouse.up()
})

test('a disc is added, resized by its rim and deleted', async ({ lab, page }) => {
  await lab.open(linkTo({}, 5))
  await lab.settled(5)
  const place: Point = [7.5, 2]
  await page.getByTestId('add-disc').click()
  const at = await lab.whereIs(shipped, place)
  await page.mouse.click(at.x, at.y)
  const added = await sceneAt(lab, 3)
  expect(added.discs).toHaveLength(shipped.discs.length + 1)
  const disc = added.discs.at(-1)
  expect(disc?.center[0]).toBeCloseTo(place[0], 1)
  expect(disc?.center[1]).toBeCloseTo(place[1], 1)

  const rim = await lab.whereIs(shipped, [(disc?.center[0] ?? 0) + (disc?.radius ?? 0), disc?.center[1] ?? 0])
  await lab.dragFrom(rim, 40, 0)
  const grown = (await sceneAt(lab, 4)).discs.at(-1)
  expect(grown?.radius).toBeGreaterThan((disc?.radius ?? 0) + 0.1)
  expect(grown?.center).toEqual(disc?.center)

  await lab.stage.focus()
  await page.keyboard.press('Delete')
  expect((await sceneAt(lab, 2)).discs).toEqual(shipped.discs)
})

test('a start inside a disc is refused with the core’s message, and nothing is lost', async ({ lab, page }) => {
  await lab.open(linkTo({}, 30))
  await lab.settled(30)
  const from = await lab.whereIs(shipped, shipped.start)
  const to = await lab.whereIs(shipped, center(6))
  await lab.dragFrom(from, to.x - from.x, to.y - from.y)
  const message = page.getByRole('alert').filter({ hasText: 'start' })
  await expect(message.first()).toBeVisible()

  await page.keyboard.press('ControlOrMeta+z')
  await expect(message).toHaveCount(0)
  expect((await sceneAt(lab, 12)).start).toEqual(shipped.start)
})

test('a scene file opens; one that is refused says why and changes nothing', async ({ lab, page }) => {
  await lab.open(linkTo({}, 8))
  const hash = await lab.settled(8)
  await lab.section('scene')
  const file = page.getByTestId('scene-file')
  const bad = { ...shipped, discs: [{ center: [4, 4], radius: -1 }] }
  await file.setInputFiles({ name: 'bad.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(bad)) })
  await expect(page.getByTestId('notice')).toContainText('radius')
  expect(await lab.settled(8)).toBe(hash)

  const good: DiscsScene = { ...shipped, name: 'mine', title: 'Mine', discs: [{ center: [4, 4], radius: 1.5 }] }
  delete good.exact
  delete good.published
  await file.setInputFiles({ name: 'mine.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(good)) })
  await expect.poll(() => lab.iteration()).toBeLessThan(8)
  expect((await sceneAt(lab, 15)).discs).toEqual(good.discs)
})

test('a planner that doesn’t run here brings a scene of its own; undone, the one before is back where it stood', async ({ lab, page }) => {
  await lab.open(linkTo({}, 8))
  const before = await lab.settled(8)
  await pick(page, 'planner', 'aco')
  const hash = await lab.seek(4)
  const there = verified(await lab.link(hash))
  expect([there.planner, there.scene.kind]).toEqual(['aco', 'grid'])
  await lab.press(en.bar.undo)
  await expect(page.getByTestId('scene')).toHaveAttribute('data-value', 'wcpso-discs')
  expect(await lab.settled(8)).toBe(before)
  await expect(page.getByTestId('planner')).toHaveAttribute('data-value', 'wcpso')
})

test('a changed parameter keeps the run before it as a ghost; both open in Compare, and the ghost is put away', async ({ lab, page }) => {
  await lab.open(linkTo({}, 40))
  const before = await lab.settled(40)
  const whole = await lab.wholePicture()
  const w = (await lab.section('parameters')).locator('[data-parameter="w_max"] input.typed')
  await w.fill('0.5')
  await w.press('Enter')
  await lab.restarted()
  const hash = await lab.settled(40)
  expect(hash).toBe(hashOf({ params: { w_max: 0.5 } }, 40))
  const fork = page.getByTestId('fork')
  await expect(fork).toContainText(forks.before(number(outcomeOf({}, 40).length, 6), '40'))
  await lab.tab('chart')
  await expect(page.getByTestId('chart')).toContainText(panels.chart.before)
  await page.getByTestId('fork-compare').click()
  await expect(page.getByTestId('lane')).toHaveCount(2)
  await expect(page).toHaveURL(/with=wcpso,wcpso;w_max=0.5/)
  await page.goBack()
  expect(await lab.settled(40)).toBe(hash)
  await page.getByTestId('fork-undo').click()
  expect(await lab.settled(40)).toBe(before)
  await expect(fork).toBeVisible()
  await page.getByTestId('fork-dismiss').click()
  await expect(fork).toHaveCount(0)
  await expect.poll(async () => (await lab.wholePicture()).digest).toBe(whole.digest)
})

test('an edited scene and what it was open side by side in Compare: each planner on its own, also after a reload', async ({
  lab,
  page,
}) => {
  await lab.open(linkTo({}, 20))
  await lab.settled(20)
  const from = await lab.whereIs(shipped, center(2))
  await lab.dragFrom(from, 30, 20)
  await lab.restarted()
  const { scene: edited } = verified(await lab.link(await lab.settled(20)))
  await page.getByTestId('fork-compare').click()
  const cards = page.getByTestId('entrant')
  await expect(cards).toHaveCount(2)
  await expect(page.getByTestId('entrant-before')).toHaveCount(1)
  await expect(cards.first().getByTestId('entrant-before')).toBeVisible()
  const titles = page.getByTestId('lane')
  await expect(titles).toHaveCount(2)
  // Both have run on their own scene: what the core finds there.
  await expect(page).toHaveURL(/with=wcpso;@=wcpso-discs,wcpso/)
  const values = async (): Promise<string[]> => page.getByTestId('lane-best').allTextContents()
  await page.getByTestId('race-end').click()
  await expect(page.getByTestId('race')).toHaveAttribute('data-over', 'true', { timeout: 30_000 })
  const own = trialOf({ planner: 'wcpso', scene: 'wcpso-discs', seed: 1 }).record.value
  const other = trialOf({ planner: 'wcpso', scene: edited, seed: 1 }).record.value
  expect(own).not.toBe(other)
  expect(await values()).toEqual([own, other].map((value) => number(value, 6)))
  await page.reload()
  await expect(page.getByTestId('entrant-before')).toHaveCount(1)
  await expect(page.getByTestId('lane')).toHaveCount(2)
})

test('in space the run before a change stays as a ghost, too', async ({ lab, page }) => {
  const setup = { planner: 'rrt-guided', scene: 'arm-cuboid', seed: 1 }
  await lab.open(linkTo(setup, 74))
  await lab.settled(74)
  expect(outcomeOf(setup, 74).tip_path?.length).toBeGreaterThan(2)
  const step = (await lab.section('parameters')).locator('[data-parameter="step_size"] input.typed')
  await step.fill('0.045')
  await step.press('Enter')
  await lab.restarted()
  await lab.settled()
  await expect(page.getByTestId('fork')).toContainText(number(outcomeOf(setup, 74).length, 6))
  const { digest } = await lab.picture()
  await page.getByTestId('fork-dismiss').click()
  await expect.poll(async () => (await lab.picture()).digest).not.toBe(digest)
})
