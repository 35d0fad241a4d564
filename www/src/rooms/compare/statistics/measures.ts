import { batch as text } from '../../../locales/en/batch'
import { isPositive, type Measure, type ValueScale } from '../../../render/plot/statistics/scale'
import type { Shown } from './shown'

/** Values that span more than so many times the smallest are easier to tell apart by their logarithm. */
const LOG_FROM = 30

/** The gap is known of every run with a result; on maps of their own gaps are all there is. */
export const hasGaps = ({ plan, groups }: Shown): boolean =>
  plan.maps === null &&
  groups.some(({ runs }) => runs.some(({ record }) => record.gap !== null)) &&
  groups.every(({ runs }) => runs.every(({ record }) => record.value === null || record.gap !== null))

/** A search over cells and one at any angle have optima of their own: their gaps say nothing about each other. */
export const haveOneReference = ({ groups }: Shown): boolean =>
  new Set(groups.flatMap(({ exact, exactBy }) => (exact === null ? [] : [exactBy]))).size < 2

export const measureOf = (shown: Shown, chosen: Measure | undefined): Measure =>
  shown.relative ? 'gap' : hasGaps(shown) ? (chosen ?? (haveOneReference(shown) ? 'gap' : 'value')) : 'value'

/** What a run comes to in a measure; null without a feasible result. */
export const valueIn = (measure: Measure, { value, gap }: { value: number | null; gap: number | null }): number | null =>
  value === null ? null : measure === 'gap' ? gap : value

/** What the values are. */
export function titleOf(shown: Shown, measure: Measure): string {
  if (measure === 'gap') return haveOneReference(shown) ? text.results.gapAxis : text.results.gapAxisOwn
  return shown.plan.scene.kind === 'function' ? text.results.cost : text.results.length
}

export function valuesOf({ groups }: Shown, measure: Measure): number[] {
  return groups.flatMap(({ runs }) => runs.map(({ record }) => valueIn(measure, record)).filter((value) => value !== null))
}

/** Whose runs take more than so many times the budget, is named. The same in the shell. */
const OVER = 1.1

/** Planners that took far more evaluations than the budget has, each with the most. */
export const overspent = ({ allowance, groups }: Pick<Shown, 'allowance' | 'groups'>): { label: string; most: number }[] =>
  groups
    .map(({ label, runs }) => ({ label, most: Math.max(0, ...runs.map(({ record }) => record.evaluations)) }))
    .filter(({ most }) => allowance !== null && most > OVER * allowance)

/** The gap up to which a length is the optimum: sums of the same steps in another order. */
export const OPTIMAL = 1e-9

/** What was chosen, if the values allow it, or what suits them. */
export function scaleOf(values: readonly number[], measure: Measure, chosen: ValueScale | undefined): ValueScale {
  const positive = values.filter((value) => isPositive(value, measure))
  if (positive.length === 0) return 'linear'
  if (chosen) return chosen
  const [low, high] = positive.reduce(([a, b], value) => [Math.min(a, value), Math.max(b, value)], [Infinity, -Infinity])
  return high > LOG_FROM * low ? 'log' : 'linear'
}
