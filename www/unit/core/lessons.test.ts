import { readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { parse } from 'csv-parse/sync'
import { describe, expect, it } from 'vitest'
import type { UncheckedSetup } from 'forage-lab'
import { catalogue } from '../../../pkg/node.js'
import { lessonsIn } from '../../plugins/lessons'
import { checkNames } from '../../src/lessons/names'
import type { Figure, Question } from '../../src/lessons/format'
import { computed, setupsOf } from '../../src/stores/lesson-figures'
import { type Truth, truthOf } from '../../src/stores/lesson-truth'
import { brief, briefPercent } from '../../src/text/brief'
import { CoreOracle } from './oracle'

const lessons = lessonsIn(fileURLToPath(new URL('../../../lessons', import.meta.url)))
const known = catalogue()
const root = fileURLToPath(new URL('../../..', import.meta.url))
const { claims: judged } = JSON.parse(readFileSync(`${root}/REPRODUCTION.claims.json`, 'utf8')) as { claims: { id: string }[] }
const rows = parse(readFileSync(`${root}/REPRODUCTION.csv`, 'utf8'), { columns: true }) as Record<string, string>[]

/** As the page writes it. */
const writtenAs = ({ as }: Figure, value: number): string => (as === 'percent' ? briefPercent(value) : brief(value))

/** A number of the reproduction's tables. */
function published(figure: Figure): number {
  if (figure.kind !== 'published') return Number.NaN
  const found = rows.filter((row) =>
    (['reproduction', 'table', 'row', 'measure'] as const).every((column) => row[column] === figure[column]),
  )
  expect(found.length, `${figure.reproduction}: ${figure.row}`).toBe(1)
  return Number(found[0]?.[figure.of] || Number.NaN)
}

/** A lesson must not teach an accident: what it says of several runs holds for this share of them. */
const MOSTLY = 0.7
const LEAST_SEEDS = 30

function holds(question: Question, truth: Truth): void {
  if (truth.kind === 'run' && truth.agree !== null && question.kind === 'run') {
    expect(question.seeds).toBeGreaterThanOrEqual(LEAST_SEEDS)
    expect(truth.agree / (question.seeds ?? 1)).toBeGreaterThanOrEqual(MOSTLY)
  }
  if (truth.kind === 'compare' && question.kind === 'compare') {
    expect(question.seeds).toBeGreaterThanOrEqual(LEAST_SEEDS)
    const [best = Number.NaN, next = Number.NaN] = [...truth.medians].sort((a, b) => a - b)
    expect(best, 'two options are equally good').toBeLessThan(next)
    expect(truth.wins[truth.option]).toBe(Math.max(...truth.wins))
  }
  // Neither nobody nor everybody can be right.
  if (truth.kind === 'cell') expect(truth.probabilities.filter((p) => p > 0).length).toBeGreaterThan(1)
}

describe.each(lessons.map((lesson) => [lesson.name, lesson] as const))('%s', (_, lesson) => {
  it('names what there is', () => {
    checkNames(lesson, known)
  })

  it('shows iterations that its runs have, and asks what the core can answer', async () => {
    const oracle = new CoreOracle()
    const setups = setupsOf(lesson)
    for (const { name, at, item, question } of lesson.steps) {
      const setup = setups.get(name) as UncheckedSetup
      const { outcome, inspection } = await oracle.at(setup, at, (item as never) ?? null)
      expect((outcome as { iterations: number }).iterations, name).toBe(at)
      if (item) expect(inspection, `${name} has nothing to explain`).not.toBeNull()
      if (question) holds(question, await truthOf(question, setup, at, oracle))
    }
  })
})

const WORDS = [800, 1200] as const
/** What may have digits in an article: names, and where a paper says something. */
const NAMES = /\{[a-z0-9-]+\}|\$[^$]*\$|\[[A-Z-]+\](?: \(\d+[^)]*\))?|\b(?:[A-Z]\d+[a-z]?|f\d|2-opt|x\d)\b/g

describe.each(lessons.filter(({ kind }) => kind === 'article').map((article) => [article.name, article] as const))(
  'the article %s',
  (_, article) => {
    const words = article.texts[article.language] ?? {}
    const prose = article.steps.map(({ text }) => words[text] ?? '').join('\n\n')

    it('has every number of its prose from a run or from the tables of the reproduction', async () => {
      expect(prose.replace(NAMES, '').match(/\S*\d\S*/g)).toBeNull()
      const oracle = new CoreOracle()
      for (const [name, figure] of Object.entries(article.numbers ?? {})) {
        const found = (await computed(figure, article, oracle)) ?? published(figure)
        expect(writtenAs(figure, found), name).toBe(writtenAs(figure, figure.value))
      }
    })

    it('is as long as an article, and ends with claims that are judged', () => {
      const count = prose.split(/\s+/).length
      expect(count).toBeGreaterThanOrEqual(WORDS[0])
      expect(count).toBeLessThanOrEqual(WORDS[1])
      expect(article.claims?.length).toBeGreaterThan(0)
      for (const id of article.claims ?? []) expect(judged.map((claim) => claim.id)).toContain(id)
    })
  },
)

it('all of a lesson is there: goals, three predictions, an experiment and notes', () => {
  for (const { kind, name, goals, steps, experiment, notes, misconception } of lessons) {
    if (kind === 'article') continue
    expect(goals?.length, name).toBeGreaterThanOrEqual(2)
    expect(steps.filter(({ question }) => question).length, name).toBeGreaterThanOrEqual(3)
    expect([experiment, notes, misconception].includes(undefined), name).toBe(false)
  }
})
