import { readFileSync } from 'node:fs'
import type { Locator } from '@playwright/test'
import { parseLink } from '../../pkg/node.js'
import { rowsOf } from '../plugins/reproduction'
import { papers as text } from '../src/locales/en/papers'
import { number } from '../src/text/number'
import { ANSWERS, CLAIM_MARKS, claimsOf, marked } from '../src/rooms/papers/claims'
import { runOf } from '../src/rooms/papers/commands'
import { groupsOf, homesOf, ours, published } from '../src/rooms/papers/figures'
import { KINDS, MARKS, NUMBERS, PAPERS, type Row } from '../src/rooms/papers/row'
import { violations } from './support/axe'
import { hashOf, trialOf } from './support/core'
import { en, expect, type Lab, test } from './support/lab'
import { Race } from './support/race'

const FILE = 'REPRODUCTION.csv'
const CLAIMS = 'REPRODUCTION.claims.json'
const [source, claimed] = [FILE, CLAIMS].map((name) => readFileSync(new URL(`../../${name}`, import.meta.url), 'utf8')) as [string, string]
const rows = rowsOf(source, FILE)
const { papers, claims } = claimsOf(claimed, CLAIMS)

/** The view, with the planners there. */
async function open(lab: Lab): Promise<void> {
  await lab.open('#view=papers')
  await expect(lab.page.getByTestId('claim-W1')).toBeVisible()
  await expect(lab.page.getByTestId('view-lab')).toBeVisible()
}

/** A claim with its questions. */
async function openClaim(lab: Lab, id: string): Promise<Locator> {
  const claim = lab.page.getByTestId(`claim-${id}`)
  await turned(claim, true)
  // What is inside is made when it is opened.
  await expect(claim.getByTestId('because')).toBeVisible()
  return claim
}

async function openAll(lab: Lab): Promise<void> {
  // Tables of figures are inside claims.
  for (const parts of ['[data-testid^="claim-"]', '[data-testid^="group-"]'])
    for (const part of await lab.page.locator(parts).all()) await turned(part, true)
}

/** Opens or closes a part. */
async function turned(part: Locator, open: boolean): Promise<void> {
  if ((await part.evaluate((node: HTMLDetailsElement) => node.open)) !== open) await part.locator('> summary').click()
}

test('every paper has a card with its title, authors, claims and their marks', { tag: '@smoke' }, async ({ lab, page }) => {
  await open(lab)
  await expect(page.getByRole('article')).toHaveCount(PAPERS.length)
  await expect(page.getByTestId('headline')).toContainText(text.headline(number(claims.length), number(rows.length)))
  for (const { tag, title, english, authors, reference, pictures } of papers) {
    const card = page.getByTestId(`paper-${tag}`)
    for (const part of [title ?? english, english]) await expect(card.getByRole('heading', { level: 3 })).toContainText(part)
    // Chinese names have a Chinese comma between them.
    const printed = (authors ?? []).map((names) => (/[\u3400-\u9fff]/.test(names) ? names.replaceAll(', ', '，') : names))
    for (const part of [...printed, reference]) await expect(card.getByTestId('citation')).toContainText(part)
    const mine = claims.filter(({ paper }) => paper === tag)
    for (const [mark, count] of marked(mine))
      await expect(card.getByTestId('summary')).toContainText(text.count(number(count), text.names.claim[mark]))
    await expect(card.locator('[data-testid^="claim-"]')).toHaveCount(mine.length)
    for (const { id, says, mark } of mine) {
      const summary = card.getByTestId(`claim-${id}`).locator('> summary')
      await expect(summary).toContainText(text.names.claim[mark])
      await expect(summary).toContainText(`${id} ${says}`)
    }
    await expect(card.getByTestId('pictures').getByRole('listitem')).toHaveCount(pictures.length)
  }
  const total = page.getByTestId('overview').locator('tfoot td.number')
  await expect(total).toHaveText(marked(claims).map(([, count]) => number(count)))
})

/** The marks of a row, in words: all of them, or without those that say nothing new. */
const told = ({ marks }: Row, all: boolean): string[] =>
  KINDS.flatMap((kind) => {
    const mark = marks[kind]?.mark
    return mark && (all || !['printed', 'consistent'].includes(mark)) ? [(text.names[kind] as Record<string, string>)[mark] ?? ''] : []
  })

test('the figures are those of the file, published beside ours, with marks, reasons and command', async ({ lab, page }) => {
  await open(lab)
  await openAll(lab)
  for (const paper of PAPERS) {
    const shown = page.getByTestId(`paper-${paper}`).locator('[data-testid^="group-"]')
    const all = groupsOf(rows, paper)
    // In the order of the claims at which they are shown; those of none come last.
    const mine = claims.filter((claim) => claim.paper === paper)
    const homes = homesOf(all, mine)
    const groups = [...mine.map(({ id }) => id), undefined].flatMap((claim) => all.filter(({ id }) => homes.get(id) === claim))
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
})

test('a claim has its quotation, its reason and its questions, with tests and answers', async ({ lab, page }) => {
  await open(lab)
  for (const { id, quotation, place, because, reading, parts, mark } of claims) {
    const claim = await openClaim(lab, id)
    await expect(claim).toHaveAttribute('data-mark', mark)
    await expect(claim.locator('blockquote')).toHaveText(quotation)
    await expect(claim.locator('blockquote')).toHaveAttribute('lang', 'zh-CN')
    await expect(claim).toContainText(text.place(place))
    await expect(claim.getByTestId('because')).toContainText(`${because}. ${reading}`.trim())
    const lines = claim.getByTestId('question')
    await expect(lines).toHaveCount(parts.length)
    const found = await lines.evaluateAll((rows) =>
      rows.map((row) => ({ head: row.querySelector('th')?.textContent, answer: row.dataset.answer, words: row.textContent ?? '' })),
    )
    for (const [k, { question, numbers, test: name, answer, arms }] of parts.entries()) {
      expect(found[k]).toMatchObject({ head: question, answer })
      for (const part of [numbers, name, text.names.answer[answer], ...arms.map(({ planner }) => planner)])
        expect(found[k]?.words).toContain(part)
    }
    await turned(page.getByTestId(`claim-${id}`), false)
  }
})

test('the runs of a question open in the stage, as a batch and as a race, with its parameters and seeds', async ({ lab, page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await open(lab)
  const claim = await openClaim(lab, 'W5')
  const line = claim.getByTestId('question').first()
  await expect(line.getByTestId('open-run')).toHaveText(['wcpso', /^wcpso, c1_law linear/])
  await line.getByTestId('open-run').last().click()
  await expect(page.getByTestId('view-lab')).toHaveAttribute('aria-current', 'page')
  await expect(page.getByTestId('view-lab')).toBeFocused()
  const params = { perturb: false, w_law: 'linear', c1_law: 'linear', c2_law: 'linear' }
  const link = parseLink(await lab.link(await lab.settled(0)))
  expect({ planner: link.planner, scene: link.scene.name, params: link.params, seed: link.seed }).toEqual({
    planner: 'wcpso',
    scene: 'sphere',
    params,
    seed: 51,
  })
  await page.getByTestId('view-papers').click()
  await (await openClaim(lab, 'O1a')).getByTestId('open-statistics').click()
  await expect(page.getByTestId('view-compare')).toHaveAttribute('aria-current', 'page')
  await expect(page.getByTestId('batch-from')).toHaveValue('51')
  await expect(page.getByTestId('batch-count')).toHaveValue('100')
  await page.getByTestId('batch-count').fill('2')
  await page.getByTestId('batch-count').press('Enter')
  await page.getByTestId('batch-run').click()
  await expect(page.getByTestId('batch-bar')).toHaveAttribute('data-done', '2')
  for (const seed of [51, 52]) {
    const { hash } = trialOf({ planner: 'aco-wolf', scene: 'wolf-ant-20', params: { beta: 7, rho: 0.367 }, seed }).record
    await expect(page.locator(`[data-testid=batch-row][data-seed="${seed}"]`)).toHaveAttribute('data-hash', hash)
  }
  await page.getByTestId('view-papers').click()
  await (await openClaim(lab, 'L2a')).getByTestId('open-watch').first().click()
  await expect(page.getByTestId('view-compare')).toHaveAttribute('aria-current', 'page')
  const race = new Race(page)
  await expect(race.lanes).toHaveCount(2)
  for (const { planner, iteration, hash } of await race.standings())
    expect(hash).toBe(hashOf({ planner, scene: 'sphere-4', params: { c1: 1 }, seed: 51 }, iteration))
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
  await openClaim(lab, 'L1a')
  const group = page.getByTestId(`group-${row.reproduction}`).and(page.locator(`[data-table="${row.table}"]`))
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
  await openClaim(lab, 'W1')
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
  const heading = page.locator('#paper-WOLF-ANT')
  await expect(heading).toBeFocused()
  await expect(heading).toBeInViewport()
  await page.keyboard.press('Tab')
  await expect(page.getByTestId('claim-O1a').locator('> summary')).toBeFocused()
  await page.keyboard.press('Enter')
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
        // A claim with its table is looked at, with a reason; the others are closed: axe takes its time.
        const claim = await openClaim(lab, 'O1a')
        const groups = claim.locator('[data-testid^="group-"]')
        const [last, ...others] = (await groups.all()).reverse()
        if (last === undefined) throw new Error('a claim without figures')
        for (const group of others) await turned(group, false)
        await turned(last, true)
        await last.locator('td.why button').first().click()
        await turned(page.getByTestId('rule'), true)
        await expect(page.getByTestId('figure-more')).toHaveCount(1)
        expect(await violations(lab)).toEqual([])
        expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(viewport.width)
      })
    })
  }
}

test('the rule of every mark is told', async ({ lab, page }) => {
  await open(lab)
  await turned(page.getByTestId('rule'), true)
  await expect(page.getByTestId('rule').locator('[data-kind=answer]')).toHaveText(ANSWERS.map((mark) => text.names.answer[mark]))
  await expect(page.getByTestId('rule').locator('[data-kind=claim]')).toHaveText(CLAIM_MARKS.map((mark) => text.names.claim[mark]))
  for (const kind of KINDS) {
    await expect(page.getByTestId('rule').getByRole('heading', { name: text.kinds[kind].title, exact: true })).toBeVisible()
    const shown = page.getByTestId('rule').locator(`[data-kind=${kind}]`)
    await expect(shown).toHaveText(MARKS[kind].map((mark) => (text.names[kind] as Record<string, string>)[mark] ?? ''))
    for (const rule of Object.values(text.rule.marks[kind])) await expect(page.getByTestId('rule')).toContainText(rule)
  }
})

test.describe('on a phone', () => {
  test.use({ viewport: screens.phone, hasTouch: true, isMobile: true })

  test('nothing is too wide or too low, with claims and tables open', { tag: '@smoke' }, async ({ lab, page }) => {
    await open(lab)
    for (const id of ['W5', 'L1a', 'A2a', 'R3a', 'O2a']) await openClaim(lab, id)
    for (const group of await page.locator('[data-testid^="group-"]').all()) await turned(group, true)
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
  await expect(page.getByTestId('claim-W1')).toBeVisible()
  expect(asked.some((url) => /Papers/.test(url))).toBe(true)
  await expect(page.getByRole('heading', { name: en.views.titles.papers, exact: true })).toBeVisible()
})
