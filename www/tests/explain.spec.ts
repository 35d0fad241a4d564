import type { Inspection, Item } from 'forage-lab'
import type { Session } from 'forage-lab/core'
import { closer } from '../src/locales/en/closer'
import { number } from '../src/text/number'
import { violations } from './support/axe'
import { hashOf, linkTo, sceneOf, sessionAt } from './support/core'
import { expect, type Lab, test } from './support/lab'

const SETUP = { planner: 'pso', scene: 'wcpso-discs', seed: 3, params: { population: 12 } }
const AT = 12
const ITEM: Item = { role: 'particles', index: 4 }

const asked = (ask: (session: Session) => Inspection | null): Inspection => {
  const told = sessionAt(SETUP, AT, ask)
  if (!told) throw new Error('nothing there')
  return told
}
const supposed = (name: string, draw = 0): Inspection => asked((session) => session.suppose(ITEM, name, draw))
const cost = ({ values }: Inspection): string => number(values.find(({ name }) => name === 'cost')?.value)

async function begin(lab: Lab): Promise<void> {
  await lab.open(`${linkTo(SETUP, AT)}&page.item=${ITEM.role}.${ITEM.index}`)
  await lab.settled(AT)
  await expect(lab.page.getByTestId('what-if')).toBeVisible()
}

test('what is supposed is what the core computes on a copy; the run stays as it is', async ({ lab, page }) => {
  await begin(lab)
  const told = asked((session) => session.inspect(ITEM))
  expect(told.suppositions.map(({ name }) => name)).toEqual(['inertia', 'own', 'best', 'random'])
  const answer = page.getByTestId('supposed')
  const seen = new Set([(await lab.wholePicture()).digest])
  const choose = async (name: string, draw = 0): Promise<void> => {
    const would = supposed(name, draw)
    await expect(answer).toContainText(would.summary)
    await expect(answer).toContainText(closer.inspect.instead(cost(would), cost(told)))
    seen.add((await lab.wholePicture()).digest)
    await expect(page.getByTestId('inspect-key').locator('[data-role="supposed"]')).toBeVisible()
  }
  for (const { name, title } of told.suppositions) {
    await page.getByRole('radio', { name: title, exact: true }).check({ force: true })
    await choose(name)
  }
  for (const draw of [1, 2]) {
    await page.getByTestId('draw-again').click()
    await choose('random', draw)
  }
  // Each has a ghost of its own.
  expect(seen.size).toBe(7)
  await page.getByRole('radio', { name: closer.inspect.asItWas }).check({ force: true })
  await expect(answer).toBeEmpty()
  await lab.layer('exact', false)
  expect(await lab.settled(AT)).toBe(hashOf(SETUP, AT))
  // A step on, the same is supposed of the next step.
  await page.getByRole('radio', { name: told.suppositions[0]?.title, exact: true }).check({ force: true })
  await lab.seek(AT + 1)
  const next = sessionAt(SETUP, AT + 1, (session) => session.suppose(ITEM, 'inertia'))
  await expect(answer).toContainText(next?.summary ?? 'nothing')
})

test('an arrow, its term and its line in the key light each other', async ({ lab, page }) => {
  await begin(lab)
  const key = (role: string) => page.getByTestId('inspect-key').locator(`[data-role="${role}"] button`)
  const term = (role: string) => page.getByTestId('live-velocity').locator(`.math .${role}`).first()
  await expect(term('social')).toHaveCSS('color', /./)
  await term('social').hover()
  await expect(key('social')).toHaveAttribute('aria-pressed', 'true')
  await expect(key('inertia')).toHaveAttribute('aria-pressed', 'false')
  const lit = (await lab.picture()).digest
  await key('inertia').focus()
  await expect(term('inertia')).toHaveClass(/lit/)
  await expect(term('social')).not.toHaveClass(/lit/)
  await expect.poll(async () => (await lab.picture()).digest).not.toBe(lit)
  // The longest of the arrows by which the swarm's best draws it, in its middle.
  const marks = asked((session) => session.inspect(ITEM)).layers
  const { vertices = [] } = marks.find(({ role }) => role === 'social') ?? {}
  const arrows = vertices.flatMap((from, at) => (at % 2 === 0 ? [[from, vertices[at + 1] ?? from] as const] : []))
  const [longest] = arrows.sort(([a, b], [c, d]) => Math.hypot(d[0] - c[0], d[1] - c[1]) - Math.hypot(b[0] - a[0], b[1] - a[1]))
  if (!longest) throw new Error('no arrow')
  const [from, to] = longest
  const scene = sceneOf(SETUP)
  if (scene.kind === 'arm') throw new Error('in space')
  const { x, y } = await lab.whereIs(scene, [0.55 * from[0] + 0.45 * to[0], 0.55 * from[1] + 0.45 * to[1]])
  await page.mouse.move(x, y)
  await expect(term('social')).toHaveClass(/lit/)
  await page.mouse.move(x - 100, y + 100)
  await expect(page.locator('.math .lit')).toHaveCount(0)
})

for (const colorScheme of ['light', 'dark'] as const) {
  test.describe(colorScheme, () => {
    test.use({ colorScheme })

    test('keys alone reach each depth of an explanation, and axe finds nothing wrong with it', async ({ lab, page }) => {
      await begin(lab)
      await page.getByRole('radio', { name: closer.inspect.asItWas }).focus()
      for (let k = 0; k < 4; k += 1) await page.keyboard.press('ArrowRight')
      await expect(page.getByTestId('supposed')).toContainText(supposed('random').summary)
      await page.keyboard.press('Tab')
      await page.keyboard.press('Enter')
      await expect(page.getByTestId('supposed')).toContainText(supposed('random', 1).summary)
      for (const id of ['inspect-table', 'inspect-values']) {
        await page.keyboard.press('Tab')
        await expect(page.getByTestId(`section-${id}`).locator('summary')).toBeFocused()
        await page.keyboard.press('Enter')
        await expect(page.getByTestId(`section-${id}`)).toHaveAttribute('open', '')
        if (id !== 'inspect-table') continue
        await expect(page.getByTestId('inspect').locator('tbody tr')).not.toHaveCount(0)
        // A table that is too wide can be scrolled.
        await page.keyboard.press('Tab')
      }
      await page.getByTestId('inspect-key').locator('button').nth(2).focus()
      expect(await violations(lab)).toEqual([])
    })
  })
}

for (const [planner, scene, role, index, formula] of [
  ['aco-direction', 'ant-bat-30', 'pheromone', 781, 'choice'],
  ['aco-direction', 'ant-bat-30', 'ants', 3, 'laid'],
  ['a-star', 'ant-bat-30', 'closed', 752, 'f'],
  ['rrt', 'wcpso-discs', 'nodes', 20, 'extend'],
  ['tour-pso', 'random-52', 'tours', 3, 'position'],
  ['bat', 'random-52', 'tours', 5, 'tries'],
  ['a-star-drive', 'crossing', 'moving', 0, 'approach'],
  ['bat-continuous', 'sphere-2', 'particles', 4, 'bat-velocity-toward'],
  ['cuckoo-search', 'sphere-2', 'particles', 6, 'levy-flight'],
] as const)
  test(`${planner}: what its ${role} did has terms that are marks, and can be supposed otherwise`, async ({ lab, page }) => {
    const [setup, item, at] = [{ planner, scene, seed: 4 }, { role, index }, 30]
    const told = sessionAt(setup, at, (session) => session.inspect(item))
    if (!told) throw new Error('nothing there')
    await lab.open(`${linkTo(setup, at)}&page.item=${role}.${index}`)
    await lab.settled(at)
    const terms = page.locator(`li:has([data-testid="live-${formula}"]) .math .term`)
    await expect(terms.first()).toBeVisible()
    const classes = await terms.evaluateAll((found) => found.map((term) => [...term.classList]))
    const marked: string[] = told.layers.map((mark) => mark.role)
    const named = classes.flat().filter((name) => marked.includes(name))
    expect(named.length, `${classes.join()} of ${marked.join()}`).toBeGreaterThan(0)
    // The term, its line in the key and its mark: one colour, and they light each other.
    await terms.first().hover()
    const [lit] = classes[0]?.filter((name) => marked.includes(name)) ?? []
    await expect(page.getByTestId('inspect-key').locator(`[data-role="${lit}"] button`)).toHaveAttribute('aria-pressed', 'true')
    const dark = (await lab.picture()).digest
    await page.mouse.move(0, 0)
    await expect.poll(async () => (await lab.picture()).digest).not.toBe(dark)
    expect(told.suppositions).not.toEqual([])
    for (const { name, title } of told.suppositions) {
      const would = sessionAt(setup, at, (session) => session.suppose(item, name))
      expect(
        would?.layers.map((mark) => mark.role),
        name,
      ).toContain('supposed')
      await page.getByTestId('what-if').getByRole('radio', { name: title, exact: true }).check({ force: true })
      await expect(page.getByTestId('supposed')).toContainText(would?.summary ?? 'nothing')
    }
    expect(await lab.settled(at)).toBe(hashOf(setup, at))
  })
