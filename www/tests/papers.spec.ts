import { readFileSync } from 'node:fs'
import type { Locator } from '@playwright/test'
import { catalogue, type ParameterValue, parseLink } from '../../pkg/node.js'
import { checksOf, rowsOf } from '../plugins/reproduction'
import { papers as text } from '../src/i18n/papers.en'
import { number } from '../src/panels/format'
import { runOf } from '../src/papers/commands'
import { groupsOf, ours, published, tally, together } from '../src/papers/figures'
import { KINDS, MARKS, NUMBERS, PAPERS, type Row } from '../src/papers/row'
import { violations } from './support/axe'
import { hashOf, trialOf } from './support/core'
import { en, expect, type Lab, test } from './support/lab'
import { Race } from './support/race'

const FILE = 'REPRODUCTION.csv'
const REPORT = 'REPRODUCTION.md'
const [source, report] = [FILE, REPORT].map((name) => readFileSync(new URL(`../../${name}`, import.meta.url), 'utf8')) as [string, string]
const rows = rowsOf(source, FILE)
const checks = checksOf(report, REPORT)

/** The view, with the planners there. */
async function open(lab: Lab): Promise<void> {
  await lab.open('#view=papers')
  await expect(lab.page.getByTestId('open-run').first()).toBeVisible()
}

async function openAll(lab: Lab): Promise<void> {
  for (const group of await lab.page.locator('[data-testid^="group-"], [data-testid^="checks-"]').all()) {
    await turned(group, true)
  }
}

/** Opens or closes a part. */
async function turned(part: Locator, open: boolean): Promise<void> {
  if ((await part.evaluate((node: HTMLDetailsElement) => node.open)) !== open) await part.locator('> summary').click()
}

test('every paper has a card with its citation, its claims, experiments and how many figures have which mark', {
  tag: '@smoke',
}, async ({ lab, page }) => {
  await open(lab)
  await expect(page.getByRole('article')).toHaveCount(PAPERS.length)
  for (const paper of PAPERS) {
    const card = page.getByTestId(`paper-${paper}`)
    const { title, citation, claims } = text.cards[paper]
    await expect(card.getByRole('heading', { name: title })).toBeVisible()
    await expect(card).toContainText(citation)
    await expect(card.getByTestId('claims').getByRole('listitem')).toHaveText([...claims])
    expect(await card.getByTestId('open-run').count()).toBeGreaterThan(0)
    const mine = rows.filter((row) => row.paper === paper)
    if (mine.length === 0) await expect(card.getByTestId('summary')).toHaveText(text.none)
    else
      for (const [mark, count] of tally(mine, 'value'))
        await expect(card.getByTestId('summary')).toContainText(text.count(number(count), text.mark('value', mark)))
  }
})

/** The marks of a row, in words: all of them, or without those that say nothing new. */
const told = ({ marks }: Row, all: boolean): string[] =>
  KINDS.flatMap((kind) => {
    const mark = marks[kind]?.mark
    return mark && (all || !['printed', 'consistent'].includes(mark)) ? [text.mark(kind, mark)] : []
  })

test('the figures are those of the file, published beside ours, with marks, reasons and command', async ({ lab, page }) => {
  await open(lab)
  await openAll(lab)
  for (const paper of PAPERS) {
    const shown = page.getByTestId(`paper-${paper}`).locator('[data-testid^="group-"]')
    const groups = groupsOf(rows, paper)
    await expect(shown).toHaveCount(groups.length)
    for (const [k, { table, reproduction, rows: expected }] of groups.entries()) {
      const group = shown.nth(k)
      await expect(group.locator('> summary')).toContainText(text.group(table, reproduction))
      await group.locator('input[type=checkbox]').check()
      await expect(group.getByTestId('figure-more')).toHaveCount(expected.length)
      const cells = await group.getByTestId('figure').evaluateAll((lines) =>
        lines.map((line) => ({
          head: [...(line.querySelector('th')?.childNodes ?? [])]
            .filter((node) => !(node instanceof Element && node.ariaHidden))
            .map((node) => node.textContent)
            .join(''),
          numbers: [...line.querySelectorAll('td.number')].map((cell) => cell.querySelector('data')?.value ?? ''),
          texts: [...line.querySelectorAll('td.number')].map((cell) => cell.querySelector('data')?.textContent ?? ''),
          marks: [...line.querySelectorAll('td.marks [data-mark]')].map((mark) => mark.textContent?.trim()),
        })),
      )
      expect(cells).toEqual(
        expected.map((row) => ({
          head: `${row.row} ${row.measure}`,
          numbers: NUMBERS.map((name) => (row[name] === null ? '' : String(row[name]))),
          texts: NUMBERS.map((name) => {
            const value = row[name]
            if (value === null) return ''
            if (name === 'runs' || name === 'published_runs') return number(value)
            return name.startsWith('published') ? published(value) : ours(value, row)
          }),
          marks: told(row, false),
        })),
      )
      const more = await group.getByTestId('figure-more').allTextContents()
      for (const [at, row] of expected.entries()) {
        for (const kind of KINDS) expect(more[at]).toContain(row.marks[kind]?.because ?? '')
        for (const mark of told(row, true)) expect(more[at]).toContain(mark)
        expect(more[at]).toContain(row.command)
      }
    }
  }
  const total = page.getByTestId('overview').locator('tfoot td.number')
  await expect(total).toHaveText(MARKS.value.map((mark) => number(rows.filter((row) => row.marks.value?.mark === mark).length)))
})

test('what a paper claims stands with what the report says of it', async ({ lab, page }) => {
  await open(lab)
  for (const paper of PAPERS) {
    const mine = checks.filter((check) => check.paper === paper)
    expect(mine.length).toBeGreaterThan(0)
    for (const [reproduction, some] of together(mine, (check) => check.reproduction)) {
      const group = page.getByTestId(`paper-${paper}`).getByTestId(`checks-${reproduction}`)
      await expect(group.locator('> summary')).toContainText(
        text.checks.hold(number(some.filter(({ answer }) => answer === 'yes').length), number(some.length)),
      )
      await group.locator('> summary').click()
      const told = await group.getByTestId('check').allInnerTexts()
      expect(told.map((line) => line.replaceAll(/\s+/g, ' ').trim())).toEqual(
        some.map(({ answer, claim, because }) => `${text.checks.answers[answer]} ${claim} (${because})`),
      )
    }
  }
})

interface Opened {
  experiment: string
  scene: string
  planner: string
  params: Record<string, ParameterValue>
  /** What the button says, where it is more than the planner. */
  name?: string
}

const OPENED: Opened[] = [
  { experiment: 'functions', scene: 'sphere', planner: 'wcpso', params: {} },
  {
    experiment: 'sixteen',
    scene: 'qpso-10m',
    planner: 'ltqpso',
    params: { segments: 16, initial: 'normal', population: 52, iterations: 99 },
  },
  {
    experiment: 'wolves',
    scene: 'wolf-ant-20',
    planner: 'aco',
    params: { ants: 30, alpha: 1.5, beta: 8 },
    name: 'aco, ants 30, alpha 1.5, beta 8',
  },
  { experiment: 'free', scene: 'arm-free', planner: 'rrt-guided', params: { step_size: 0.05 }, name: 'rrt-guided, step_size 0.05' },
]

for (const { experiment, scene, planner, params, name } of OPENED) {
  test(`a preset opens ${planner} on ${scene} in the stage, as the paper ran it`, {
    tag: experiment === 'functions' ? ['@smoke'] : [],
  }, async ({ lab, page }) => {
    await page.emulateMedia({ reducedMotion: 'reduce' })
    await open(lab)
    const line = page.getByTestId(`experiment-${experiment}`).locator(`[data-scene="${scene}"]`)
    const title = catalogue().scenes.find((shipped) => shipped.name === scene)?.title ?? ''
    await line.getByRole('button', { name: text.open(name ?? planner, title), exact: true }).click()
    await expect(page.getByTestId('view-stage')).toHaveAttribute('aria-current', 'page')
    await expect(page.getByTestId('view-stage')).toBeFocused()
    await expect(lab.stage).toBeVisible()
    const hash = await lab.settled(0)
    expect(hash).toBe(hashOf({ planner, scene, params }, 0))
    const link = parseLink(await lab.link(hash))
    expect({ planner: link.planner, scene: link.scene.name, params: link.params, seed: link.seed }).toEqual({
      planner,
      scene,
      params,
      seed: 1,
    })
  })
}

test('a moving obstacle is seen with the seed that meets it', async ({ lab, page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await open(lab)
  await page.getByTestId('experiment-moving').getByTestId('open-run').first().click()
  const link = parseLink(await lab.link(await lab.settled(0)))
  expect([link.planner, link.scene.name, link.seed]).toEqual(['wolf-ant-drive', 'wolf-ant-20', 23])
})

test('an experiment becomes a batch, with the paper’s parameters and number of runs', async ({ lab, page }) => {
  await open(lab)
  await page.getByTestId('experiment-wolves').getByTestId('open-batch').click()
  await expect(page.getByTestId('view-batch')).toHaveAttribute('aria-current', 'page')
  await expect(page.getByTestId('entrant')).toHaveCount(3)
  expect(
    await page.getByTestId('entrant').evaluateAll((entrants) => entrants.map((entrant) => entrant.getAttribute('data-planner'))),
  ).toEqual(['a-star', 'aco', 'aco-wolf'])
  await expect(page.getByTestId('batch-from')).toHaveValue('1')
  await expect(page.getByTestId('batch-count')).toHaveValue('30')
  await page.getByTestId('batch-count').fill('2')
  await page.getByTestId('batch-count').press('Enter')
  await page.getByTestId('batch-run').click()
  await expect(page.getByTestId('batch-bar')).toHaveAttribute('data-done', '6')
  for (const seed of [1, 2]) {
    const { hash } = trialOf({ planner: 'aco', scene: 'wolf-ant-20', params: { ants: 30, alpha: 1.5, beta: 8 }, seed }).record
    await expect(page.locator(`[data-testid=batch-row][data-planner=aco][data-seed="${seed}"]`)).toHaveAttribute('data-hash', hash)
  }
})

test('an experiment becomes a race, with the paper’s parameters', async ({ lab, page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await open(lab)
  await page.getByTestId('experiment-sixteen').getByTestId('open-race').click()
  await expect(page.getByTestId('view-race')).toHaveAttribute('aria-current', 'page')
  const race = new Race(page)
  await expect(race.lanes).toHaveCount(2)
  for (const { planner, iteration, hash } of await race.standings()) {
    const params = { segments: 16, initial: 'normal', population: 52, iterations: 99 }
    expect(hash).toBe(hashOf({ planner, scene: 'qpso-10m', params }, iteration))
  }
  // The next one takes its place, and is found again.
  await page.getByTestId('view-papers').click()
  await page.getByTestId('experiment-colonies').getByTestId('open-race').click()
  await expect(race.lanes).toHaveCount(3)
  const before = await race.standings()
  expect(before.map(({ planner }) => planner)).toEqual(['aco', 'aco-dijkstra', 'aco-direction'])
  await page.getByTestId('view-papers').click()
  await page.getByTestId('view-race').click()
  expect(await race.standings()).toEqual(before)
})

test('a row’s own run opens in the stage, bit for bit what its command repeats', async ({ lab, page }) => {
  const [row, expected] =
    rows.flatMap((candidate) => {
      const found = runOf(candidate.command)
      return found && found.run.planner === 'ltqpso' && found.run.params.segments === 16 ? [[candidate, found] as const] : []
    })[0] ?? []
  if (!row || !expected) throw new Error('no such row')
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await open(lab)
  const group = page.getByTestId(`group-${row.reproduction}`).and(page.locator(`[data-table="${row.table}"]`))
  await turned(group, true)
  await group
    .locator('td.why button')
    .nth(rows.filter(({ table, reproduction }) => table === row.table && reproduction === row.reproduction).indexOf(row))
    .click()
  await group.getByTestId('open-figure').click()
  const { planner, params, seed = 0 } = expected.run
  expect(params).toEqual({
    early_stop: 0,
    initial: 'normal',
    initial_mean: 45,
    initial_std: 30,
    iterations: 99,
    population: 52,
    segments: 16,
  })
  expect(await lab.settled(0)).toBe(hashOf({ planner, scene: expected.on.scene, params, seed }, 0))
})

test('a command is copied, and it is told', async ({ lab, page, context }) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write'])
  await open(lab)
  const [row] = rows
  if (!row) throw new Error('no rows')
  const group = page.locator('[data-testid^="group-"]').first()
  await turned(group, true)
  await group.getByRole('button', { name: text.why(`${row.row}, ${row.measure}`), exact: true }).click()
  await group
    .getByTestId('figure-more')
    .getByRole('button', { name: text.copyHelp(row.command), exact: true })
    .click()
  await expect(group.getByTestId('figure-more').getByRole('status')).toHaveText(text.copied)
  expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(row.command)
})

test('all of it works by keyboard', async ({ lab, page }) => {
  await open(lab)
  await page.getByRole('button', { name: text.goto('[WOLF-ANT]') }).focus()
  await page.keyboard.press('Enter')
  const heading = page.getByRole('heading', { name: text.cards['WOLF-ANT'].title })
  await expect(heading).toBeFocused()
  await expect(heading).toBeInViewport()
  await page.keyboard.press('Tab')
  await expect(page.getByTestId('checks-wolf-ant').locator('> summary')).toBeFocused()
  const group = page.getByTestId('paper-WOLF-ANT').locator('[data-testid^="group-"]').first()
  await group.locator('> summary').focus()
  const was = await group.evaluate((node: HTMLDetailsElement) => node.open)
  await page.keyboard.press('Enter')
  expect(await group.evaluate((node: HTMLDetailsElement) => node.open)).toBe(!was)
})

const screens = { desktop: { width: 1440, height: 900 }, phone: { width: 390, height: 844 } }

for (const colorScheme of ['light', 'dark'] as const) {
  for (const [screen, viewport] of Object.entries(screens)) {
    test.describe(`${screen}, ${colorScheme}`, () => {
      test.use({ colorScheme, viewport, hasTouch: screen === 'phone' })

      test('axe finds nothing wrong with the papers', { tag: screen === 'desktop' && colorScheme === 'light' ? ['@smoke'] : [] }, async ({
        lab,
        page,
      }) => {
        await open(lab)
        // A table and a list of claims are looked at, with a reason; the others are closed: axe takes its time.
        const groups = await page.locator('[data-testid^="group-"]').all()
        for (const group of groups) await turned(group, group === groups.at(-1))
        await groups.at(-1)?.locator('td.why button').first().click()
        await turned(page.getByTestId('checks-arm-rrt'), true)
        await expect(page.getByTestId('figure-more')).toHaveCount(1)
        expect(await violations(lab)).toEqual([])
        expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(viewport.width)
      })
    })
  }
}

test('the rule of every mark is told', async ({ lab, page }) => {
  await open(lab)
  for (const kind of KINDS) {
    await expect(page.getByTestId('rule').getByRole('heading', { name: text.kinds[kind].title, exact: true })).toBeVisible()
    const shown = page.getByTestId('rule').locator(`[data-kind=${kind}]`)
    await expect(shown).toHaveText(MARKS[kind].map((mark) => text.mark(kind, mark)))
    for (const rule of Object.values(text.rule.marks[kind])) await expect(page.getByTestId('rule')).toContainText(rule)
  }
})

test.describe('on a phone', () => {
  test.use({ viewport: screens.phone, hasTouch: true, isMobile: true })

  test('nothing is too wide or too low, with everything open', { tag: '@smoke' }, async ({ lab, page }) => {
    await open(lab)
    await openAll(lab)
    for (const all of await page.locator('main input[type=checkbox]').all()) await all.check()
    expect(await page.locator('main').evaluate((main) => main.scrollWidth)).toBeLessThanOrEqual(screens.phone.width)
    const wrong = await page.locator('main').evaluate((main) => {
      const low = [...main.querySelectorAll('button, summary, label')].filter((control) => control.getBoundingClientRect().height < 43.5)
      const wide = [...main.querySelectorAll('[data-testid="figure"], [data-testid="figure-more"], code')].filter(
        (part) => part.getBoundingClientRect().right > innerWidth,
      )
      return [...low, ...wide].map((part) => part.outerHTML)
    })
    expect(wrong).toEqual([])
  })
})

test('a page that shows a run loads none of it', async ({ lab, page }) => {
  const asked: string[] = []
  page.on('request', (request) => asked.push(request.url()))
  await lab.open()
  expect(asked.filter((url) => /Papers/.test(url))).toEqual([])
  await page.getByTestId('view-papers').click()
  await expect(page.getByTestId('open-run').first()).toBeVisible()
  expect(asked.some((url) => /Papers/.test(url))).toBe(true)
  await expect(page.getByRole('heading', { name: en.views.titles.papers, exact: true })).toBeVisible()
})
