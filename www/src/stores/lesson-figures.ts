import type { RunSetup } from '../catalogue/own'
import type { Item, TrialRecord } from 'forage-lab'
import type { Figure, Lesson } from '../lessons/format'
import { median } from '../lessons/score'
import { changed, NO_RUN } from '../lessons/runs'
import { numberOf, type Oracle, setupWith } from './lesson-truth'

/** What runs at each step of a lesson. */
export function setupsOf({ steps }: Pick<Lesson, 'steps'>): Map<string, RunSetup> {
  let run = NO_RUN
  return new Map(
    steps.map((step) => {
      run = changed(run, step.run)
      return [step.name, run as RunSetup]
    }),
  )
}

/** Computes a number of a text again; null: it is a published one. */
export async function computed(figure: Figure, lesson: Lesson, oracle: Oracle): Promise<number | null> {
  if (figure.kind === 'published') return null
  const step = lesson.steps.find(({ name }) => name === figure.step)
  const setup = setupsOf(lesson).get(figure.step)
  if (!step || !setup) throw new Error(`there is no step ${figure.step}`)
  if (figure.kind === 'seeds') {
    const records = await oracle.trials(setupWith(setup, figure.run ?? {}), figure.seeds, figure.evaluations ?? null)
    if (figure.of === 'feasible') return records.filter(({ feasible }: TrialRecord) => feasible).length / records.length
    return median(records.map((record) => numberOf(record, figure.of)))
  }
  const at = figure.kind === 'moment' ? (figure.at ?? step.at) : step.at
  const item = figure.kind === 'moment' ? (figure.item ?? null) : null
  const { inspection, readings, outcome, evaluations } = await oracle.at(setup, at, item as Item | null)
  if (item) return inspection?.values.find(({ name }) => name === figure.of)?.value ?? Number.NaN
  if (figure.kind === 'moment') return numberOf({ ...outcome, readings, evaluations }, figure.of)
  const { parameters = {} } = (outcome ?? {}) as { parameters?: Readonly<Record<string, unknown>> }
  return Number(parameters[figure.of])
}
