import { fileURLToPath } from 'node:url'
import type { Page } from '@playwright/test'
import { catalogue, type Point, type Scene, type UncheckedSetup } from '../../pkg/node.js'
import { lessonsIn } from '../plugins/lessons'
import type { Lesson, Step } from '../src/lessons/format'
import { learn } from '../src/locales/en/learn'
import { lesson as text } from '../src/locales/en/lesson'
import { extent, fit as fitted, isDown, margins, toScreen } from '../src/render/view'
import { setupsOf } from '../src/stores/lesson-figures'
import { type Truth, truthOf } from '../src/stores/lesson-truth'
import { CoreOracle } from '../unit/core/oracle'
import { violations } from './support/axe'
import { finished, seeds } from './support/batch'
import { hashOf, sceneOf, verified } from './support/core'
import { SITE } from './support/site'
import { expect, type Lab, test } from './support/lab'

const lessons = lessonsIn(fileURLToPath(new URL('../../lessons', import.meta.url)))

/** Opens a lesson, and waits until its run is there. */
async function open(lab: Lab, page: Page, name: string): Promise<void> {
  await lab.open(`#lesson=${name}`)
  await expect(page.getByTestId('lesson')).toHaveAttribute('data-lesson', name)
}

const wholeOf = (setup: UncheckedSetup): Scene => sceneOf(setup)

/** Where a place of a scene is on the bare stage. */
async function onStage(page: Page, scene: Scene, at: Point, camera: Step['camera']): Promise<Point> {
  const box = await page.getByTestId('predict').boundingBox()
  if (!box) throw new Error('nothing is asked on the stage')
  const whole = fitted(extent(scene), box, margins(box.width, true), isDown(scene))
  const view = camera ? { ...whole, x: camera.center[0], y: camera.center[1], scale: whole.scale * camera.zoom } : whole
  const [x, y] = toScreen(view, box, at)
  return [box.x + x, box.y + y]
}

/** Answers that are as it was, and otherwise: options, or places. */
function answersTo(truth: Truth, setup: UncheckedSetup): [right: Point | number, wrong: Point | number] {
  switch (truth.kind) {
    case 'arrow': {
      const [x, y] = truth.from
      const [dx, dy] = [truth.to[0] - x, truth.to[1] - y]
      // The other way, and not so far that it leaves the stage.
      return [truth.to, [x - dx / 2, y - dy / 2]]
    }
    case 'cell': {
      const { centre, probabilities } = truth
      const { cell } = wholeOf(setup) as Extract<Scene, { kind: 'grid' }>
      const neighbour = (direction: number): Point => {
        const turn = (direction * Math.PI) / 4
        return [centre[0] + Math.round(Math.cos(turn)) * cell, centre[1] + Math.round(Math.sin(turn)) * cell]
      }
      return [neighbour(probabilities.indexOf(Math.max(...probabilities))), neighbour(probabilities.indexOf(Math.min(...probabilities)))]
    }
    case 'node': {
      // The root of the tree; where that is nearest, nothing is farther.
      const { start } = wholeOf(setup) as { start?: Point }
      return [truth.at, start ?? [0, 0]]
    }
    case 'member':
      return [truth.places[truth.index] ?? [0, 0], truth.places[truth.values.indexOf(Math.max(...truth.values))] ?? [0, 0]]
    default:
      return [truth.option, truth.option === 0 ? 1 : 0]
  }
}

async function give(page: Page, answer: Point | number, setup: UncheckedSetup, { camera }: Step): Promise<void> {
  if (typeof answer === 'number') {
    await here(page).getByRole('radio').nth(answer).check()
  } else {
    await page.mouse.click(...(await onStage(page, wholeOf(setup), answer, camera)))
  }
  await here(page).getByTestId('predict-answer').click()
}

/** The step that is read. */
const here = (page: Page) => page.locator('li[aria-current="step"]')

/** As it comes back from JSON. */
const plain = (value: unknown): unknown => JSON.parse(JSON.stringify(value))

async function predicts(page: Page, step: Step, setup: UncheckedSetup, oracle: CoreOracle): Promise<void> {
  if (!step.question) return
  const truth = await truthOf(step.question, setup, step.at, oracle)
  const [right, wrong] = answersTo(truth, setup)
  const prediction = here(page).getByTestId('prediction')
  for (const [answer, grades] of [
    [right, /right/],
    [wrong, /off|near/],
  ] as const) {
    if (typeof answer !== 'number') await expect(page.getByTestId('predict')).toHaveClass(/active/)
    await give(page, answer, setup, step)
    await expect(prediction).toHaveAttribute('data-grade', grades, { timeout: 30_000 })
    const shown = JSON.parse((await prediction.getAttribute('data-truth')) ?? 'null')
    expect(shown).toEqual(plain({ ...truth, inspection: undefined }))
    await prediction.getByTestId('predict-again').click()
  }
}

for (const lesson of lessons.filter(({ kind }) => kind !== 'article')) {
  test(`${lesson.name} is played to its end, with right and with other answers`, async ({ lab, page }) => {
    await page.emulateMedia({ reducedMotion: 'reduce' })
    await open(lab, page, lesson.name)
    const oracle = new CoreOracle()
    const setups = setupsOf(lesson)
    for (const [at, step] of lesson.steps.entries()) {
      const setup = setups.get(step.name) as UncheckedSetup
      await expect(page.getByTestId('lesson')).toHaveAttribute('data-step', step.name)
      expect(await lab.settled(step.at), step.name).toBe(hashOf(setup, step.at))
      await expect(page.getByTestId('lesson-away')).toHaveCount(0)
      await predicts(page, step, setup, oracle)
      if (at < lesson.steps.length - 1) await page.getByTestId('lesson-next').click()
    }
    await expect(page.getByTestId('lesson-next')).toBeDisabled()
  })
}

for (const article of lessons.filter(({ kind }) => kind === 'article')) {
  test(`${article.name} moves its run from step to step, and shows where its numbers come from`, async ({ lab, page }) => {
    await page.emulateMedia({ reducedMotion: 'reduce' })
    await open(lab, page, article.name)
    const setups = setupsOf(article)
    for (const [at, step] of article.steps.entries()) {
      const setup = setups.get(step.name) as UncheckedSetup
      await expect(page.getByTestId('lesson')).toHaveAttribute('data-step', step.name)
      expect(await lab.settled(step.at), step.name).toBe(hashOf(setup, step.at))
      await expect(here(page).locator('.markdown')).not.toContainText(/\{[a-z0-9-]+\}/)
      if (at < article.steps.length - 1) await page.getByTestId('lesson-next').click()
    }
    expect(await violations(lab)).toEqual([])
    for (const id of article.claims ?? []) await expect(page.getByTestId(`article-claim-${id}`)).toBeVisible()
    const figure = page.locator('button.figure').first()
    await figure.click()
    const places = Object.values(article.numbers ?? {}).flatMap((number) =>
      number.kind === 'moment' ? [number.at ?? article.steps.find(({ name }) => name === number.step)?.at] : [],
    )
    await lab.settled()
    expect(places).toContain(await lab.iteration())
  })
}

const FIRST = lessons[0] as Lesson

test('a lesson is left for a run of one’s own, and come back to', { tag: '@smoke' }, async ({ lab, page }) => {
  await open(lab, page, FIRST.name)
  await page.getByTestId('lesson-next').click()
  const [, step] = FIRST.steps
  const hash = await lab.settled(step?.at)
  await lab.seek(30)
  await expect(page.getByTestId('lesson-away')).toContainText(text.away.moved)
  await page.getByTestId('lesson-return').click()
  expect(await lab.settled(step?.at)).toBe(hash)
  // In the Lab it is another run; the lesson waits.
  await page.getByTestId('view-lab').click()
  await page.getByTestId('seed').fill('7')
  await page.getByTestId('seed').press('Enter')
  await page.getByTestId('view-learn').click()
  await expect(page.getByTestId('lesson')).toHaveAttribute('data-step', step?.name ?? '')
  await expect(page.getByTestId('lesson-away')).toContainText(text.away.forked)
  await page.getByTestId('lesson-return').click()
  expect(await lab.settled(step?.at)).toBe(hash)
  await expect(page.getByTestId('lesson-away')).toHaveCount(0)
})

test('a lesson ends in a task, and its run is handed in as a link', async ({ lab, page, context }) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write'])
  const { task } = FIRST
  await open(lab, page, FIRST.name)
  await page.getByTestId('task-begin').click()
  await lab.settled(0)
  await expect(page.getByTestId('task')).toHaveAttribute('data-reached', 'false')
  await lab.seek(1000)
  await expect(page.getByTestId('task-standing')).toContainText(text.tasks.over)
  await page.getByTestId('task-hand-in').click()
  await expect(page.getByText(text.tasks.copied)).toBeVisible()
  const link = await page.evaluate(() => navigator.clipboard.readText())
  expect(verified(new URL(link).hash)).toMatchObject({ planner: task?.planner, scene: { name: task?.scene }, iteration: 1000 })
})

test('scrolling moves the run', async ({ lab, page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await open(lab, page, FIRST.name)
  const [, , third] = FIRST.steps
  const article = page.locator(`article[data-step="${third?.name}"]`)
  await page.getByRole('heading', { level: 2 }).first().hover()
  await expect
    .poll(async () => {
      await page.mouse.wheel(0, 100)
      return (await article.boundingBox())?.y ?? Number.POSITIVE_INFINITY
    })
    .toBeLessThan(380)
  await expect(page.getByTestId('lesson')).toHaveAttribute('data-step', third?.name ?? '')
  await lab.settled(third?.at)
})

test('progress is kept in this browser, and can be deleted', async ({ lab, page }) => {
  await open(lab, page, FIRST.name)
  for (let step = 1; step < 3; step += 1) await page.getByTestId('lesson-next').click()
  await expect(page).toHaveURL(new RegExp(`#view=learn&lesson=${FIRST.name}&step=${FIRST.steps[2]?.name}$`))
  await page.getByTestId('lesson-close').click()
  const entry = page.getByTestId(`open-lesson-${FIRST.name}`)
  await expect(entry).toContainText(text.readTo(3, FIRST.steps.length))
  await page.reload()
  await expect(entry).toContainText(text.readTo(3, FIRST.steps.length))
  await entry.click()
  await expect(page.getByTestId('lesson')).toHaveAttribute('data-step', FIRST.steps[2]?.name ?? '')
  await page.goBack()
  await page.getByTestId('forget-progress').click()
  await expect(entry).not.toContainText(text.readTo(3, FIRST.steps.length))
  expect(await page.evaluate(() => localStorage.getItem('forage.lessons'))).toBeNull()
})

test('answers of before are there, and those of another version are not', async ({ lab, page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  const asked = FIRST.steps.filter(({ question }) => question)
  const [arrow, member] = [
    asked.find(({ question }) => question?.kind === 'arrow'),
    asked.find(({ question }) => question?.kind === 'member'),
  ]
  const answers = { [arrow?.name ?? '']: { option: 1 }, [member?.name ?? '']: { point: [0, 0] } }
  await page.addInitScript(
    ([name, kept]) => localStorage.setItem('forage.lessons', JSON.stringify({ [name as string]: { step: 0, farthest: 7, answers: kept } })),
    [FIRST.name, answers] as const,
  )
  await open(lab, page, FIRST.name)
  const card = (name: string | undefined) => page.locator(`article[data-step="${name}"]`).getByTestId('prediction')
  await expect(card(member?.name)).toContainText(text.answered)
  await expect(card(arrow?.name).getByTestId('predict-answer')).toBeVisible()
  await lab.open(`#view=learn&lesson=${FIRST.name}&step=${member?.name}`)
  await expect(card(member?.name)).toHaveAttribute('data-grade', /right|near|off/)
  await lab.settled((member?.at ?? 0) + 1)
})

test('an arrow is drawn with the keys alone', async ({ lab, page }) => {
  const at = FIRST.steps.findIndex(({ question }) => question?.kind === 'arrow')
  await lab.open(`#view=learn&lesson=${FIRST.name}&step=${FIRST.steps[at]?.name}`)
  await lab.settled(FIRST.steps[at]?.at)
  const layer = page.getByTestId('predict')
  await expect(layer).toHaveClass(/active/)
  await layer.focus()
  for (let step = 0; step < 5; step += 1) await page.keyboard.press('ArrowUp')
  await page.keyboard.press('Enter')
  await expect(here(page).getByTestId('feedback')).toBeVisible()
})

test('a lesson is accessible, at every width', async ({ lab, page }) => {
  const at = FIRST.steps.findIndex(({ question }) => question?.kind === 'arrow')
  await lab.open(`#view=learn&lesson=${FIRST.name}&step=${FIRST.steps[at]?.name}`)
  await expect(page.getByTestId('predict')).toHaveClass(/active/)
  for (const [width, height] of [
    [1440, 900],
    [390, 844],
    [320, 640],
  ] as const) {
    await page.setViewportSize({ width, height })
    expect(await violations(lab)).toEqual([])
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width)
  }
})

test('a lesson is embedded: by an iframe and by the element', { tag: '@smoke' }, async ({ lab, page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  const [, second] = FIRST.steps
  const shown = page.getByTestId('lesson')
  await lab.open(`?embed#lesson=${FIRST.name}&step=${second?.name}`)
  await expect(shown).toHaveAttribute('data-step', second?.name ?? '')
  const hash = await lab.settled(second?.at)
  await expect(page.getByTestId('whole')).toHaveAttribute('href', /#lesson=/)

  await page.goto(`${SITE}course.html`)
  await page.evaluate(
    (src) =>
      document.body.insertAdjacentHTML(
        'afterbegin',
        `<forage-run id="lesson" src="${src}" style="width: 960px; height: 600px"></forage-run>`,
      ),
    `#lesson=${FIRST.name}&step=${second?.name}`,
  )
  const element = page.locator('#lesson')
  await expect(element.getByTestId('lesson')).toHaveAttribute('data-step', second?.name ?? '')
  await expect(element).toHaveAttribute('data-hash', hash)
  await element.getByTestId('lesson-back').click()
  await expect(element.getByTestId('lesson')).toHaveAttribute('data-step', FIRST.steps[0]?.name ?? '')
  await expect(element).toHaveAttribute('data-iteration', '0')
})

test('the dialog gives what shows a lesson on another page', async ({ lab, page }) => {
  await open(lab, page, FIRST.name)
  await page.getByTestId('embed').click()
  await expect(page.getByTestId('embed-dialog').locator('textarea')).toHaveValue(
    new RegExp(`#lesson=${FIRST.name}&amp;step=${FIRST.steps[0]?.name}`),
  )
})

test('a lesson that there is not is said, and the page is there', async ({ lab, page }) => {
  await lab.open('#lesson=nothing')
  await expect(page.getByRole('alert')).toContainText(learn.unknown('nothing'))
  await expect(page.getByTestId('learn-open')).toBeVisible()
})

for (const { name, steps, experiment } of lessons) {
  if (!experiment) continue
  test(`the experiment of ${name} opens in Compare: every planner runs, none is refused or left out`, async ({ lab, page }) => {
    await lab.open(`#lesson=${name}&step=${steps.at(-1)?.name}`)
    await page.getByTestId('lesson-compare').click()
    const asked = new URLSearchParams(experiment.compare.slice(1))
    const entrants = (asked.get('with') ?? '').split(',')
    const [first = 0, last = 0] = (asked.get('seeds') ?? '').split('-').map(Number)
    await expect(page.getByTestId('entrant')).toHaveCount(entrants.length)
    await expect(page.getByTestId('batch-count')).toHaveValue(String(last - first + 1))
    for (const [at, entrant] of entrants.entries()) {
      const [planner, ...changed] = entrant.split(';')
      const shown = page.getByTestId('entrant').nth(at)
      await expect(shown).toHaveAttribute('data-planner', planner ?? '')
      const { parameters = [] } = catalogue().planners.find(({ name }) => name === planner) ?? {}
      for (const [name = '', value] of changed.map((change) => change.split('='))) {
        const usual = parameters
          .filter((parameter) => parameter.name === name)
          .flatMap(({ default: one, defaults = {} }) => [one, ...Object.values(defaults)])
        if (!usual.map(String).includes(String(value))) await expect(shown).toContainText(`${name} = ${value}`)
      }
    }
    // What fifty seeds come to is for the reader: two tell whether it runs.
    await seeds(page, 2)
    await page.getByTestId('batch-run').click()
    await finished(page, 2 * entrants.length)
    await expect(page.getByRole('alert')).toHaveCount(0)
    await expect(page.getByTestId('batch-summary').locator('tbody tr')).toHaveCount(entrants.length)
  })
}
