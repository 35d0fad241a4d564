import { fileURLToPath } from 'node:url'
import { describe, expect, it } from 'vitest'
import type { UncheckedSetup } from 'forage-lab'
import { catalogue } from '../../../pkg/node.js'
import { lessonsIn } from '../../plugins/lessons'
import { checkNames } from '../../src/lessons/names'
import type { Question } from '../../src/lessons/format'
import { changed, type Truth, truthOf } from '../../src/stores/lesson-truth'
import { CoreOracle } from './oracle'

const lessons = lessonsIn(fileURLToPath(new URL('../../../lessons', import.meta.url)))
const known = catalogue()

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
    let setup: UncheckedSetup = { planner: '', scene: '', params: {}, seed: 1 }
    for (const { name, run, at, item, question } of lesson.steps) {
      if (run) setup = changed(setup, run)
      const { outcome, inspection } = await oracle.at(setup, at, (item as never) ?? null)
      expect((outcome as { iterations: number }).iterations, name).toBe(at)
      if (item) expect(inspection, `${name} has nothing to explain`).not.toBeNull()
      if (question) holds(question, await truthOf(question, setup, at, oracle))
    }
  })
})

it('all of a lesson is there: goals, three predictions, an experiment and notes', () => {
  for (const { kind, name, goals, steps, experiment, notes, misconception } of lessons) {
    if (kind === 'article') continue
    expect(goals?.length, name).toBeGreaterThanOrEqual(2)
    expect(steps.filter(({ question }) => question).length, name).toBeGreaterThanOrEqual(3)
    expect([experiment, notes, misconception].includes(undefined), name).toBe(false)
  }
})
