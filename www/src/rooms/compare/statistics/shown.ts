import type { GroupSummary, Summary, TrialRecord } from 'forage-lab'
import type { Answered, Row } from '../../../engine/trial.protocol'
import type { Group } from './statistics-worker'
import type { Plan } from '../plan/plan'

/** Values nearer to each other than this share of them are the same. */
const SAME = 1e-12

/** A run as it is drawn and tabled. */
export interface Run {
  /** The place of its group. */
  group: number
  row: Row
  record: TrialRecord
  /** Farther from the quartiles than 1.5 times their distance. */
  outlier: boolean
}

export interface ShownGroup extends Group {
  summary: GroupSummary
  runs: Run[]
  /** The optimum that its runs are measured by; null if there is none. */
  exact: number | null
  /** Whose optimum that is. */
  exactBy: Exclude<TrialRecord['exact_by'], 'refuted'>
}

/** The results at one moment. */
export interface Shown {
  plan: Plan
  /** Evaluations at which runs were stopped; null: by their own iterations. */
  allowance: number | null
  /** By the gaps to each run's own optimum: summaries, tests and curves. */
  relative: boolean
  groups: ShownGroup[]
  answer: Answered
  /** Smaller numbers of seeds at which the tests were seen before. */
  looked: readonly number[]
}

export const WHISKER = 1.5

/** The farthest that is no outlier, on both sides. */
export function fences({ lower, upper }: Summary): [number, number] {
  const reach = WHISKER * (upper - lower)
  return [lower - reach, upper + reach]
}

/** Lengths on different maps say nothing about each other; how far they are above each map's optimum does. */
export const inGaps = ({ maps }: Plan, groups: readonly Group[]): boolean =>
  maps !== null && groups.every(({ rows }) => rows.every(({ record }) => record.value === null || record.gap !== null))

export function shownOf(
  { plan, allowance }: Pick<Shown, 'plan' | 'allowance'>,
  groups: readonly Group[],
  answer: Answered,
  looked: readonly number[],
  relative: boolean,
): Shown {
  // What runs are measured by: on maps of their own they may have nothing in common.
  const common = (rows: readonly Row[]): number | null => {
    const exact = rows[0]?.record.exact ?? null
    return relative ? 0 : rows.every(({ record }) => record.exact === exact) ? exact : null
  }
  return {
    plan,
    allowance,
    answer,
    looked,
    relative,
    groups: groups.flatMap((group, at) => {
      const summary = answer.comparison.groups[at]
      const first = group.rows[0]?.record
      if (!summary || !first) return []
      const [low, high] = summary.summary ? fences(summary.summary) : [-Infinity, Infinity]
      const runs = group.rows.map((row): Run => {
        const value = row.record.value === null || !relative ? row.record.value : row.record.gap
        const rounding = SAME * Math.abs(value ?? 0)
        return { group: at, row, record: row.record, outlier: value !== null && (value < low - rounding || value > high + rounding) }
      })
      return [{ ...group, summary, runs, exact: common(group.rows), exactBy: first.exact_by === 'refuted' ? 'stored' : first.exact_by }]
    }),
  }
}
