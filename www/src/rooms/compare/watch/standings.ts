import type { TrialCurve } from 'forage-lab'

/** What a racer has to show at a time of the race. */
export interface Mark {
  /** The feasible best, and how much was evaluated when it was found. */
  value: number
  found: number
}

/** A racer's feasible best where it stands: the last change that isn't after it. */
export function markAt(curve: TrialCurve | null, iteration: number): Mark | null {
  if (!curve) return null
  let at = -1
  while (at + 1 < curve.iterations.length && (curve.iterations[at + 1] ?? Infinity) <= iteration) at += 1
  const [value, found] = [curve.values[at], curve.evaluations[at]]
  return value === undefined || found === undefined ? null : { value, found }
}

/** Two results that differ by rounding alone are equal. */
const ROUNDING = 1e-12

/** Smaller is better; of equals, whoever found it with fewer evaluations. */
export function before(a: Mark | null, b: Mark | null): number {
  if (!a || !b) return Number(a === null) - Number(b === null)
  const apart = a.value - b.value
  return Math.abs(apart) > ROUNDING * Math.max(Math.abs(a.value), Math.abs(b.value)) ? apart : a.found - b.found
}

/** Each racer's rank from 1, shared by equals; null without a feasible result. */
export function ranks(marks: readonly (Mark | null)[]): (number | null)[] {
  return marks.map((mark) => mark && 1 + marks.filter((other) => other && before(other, mark) < 0).length)
}
