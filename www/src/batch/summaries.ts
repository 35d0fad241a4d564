import type { Row } from './plan'

type Curve = Row['curve']

/** The best values of many runs over evaluations: a step function for each quartile. */
export interface Bands {
  evaluations: number[]
  /** For each group; null where it falls on runs without a feasible result, and after the longest run's end. */
  groups: { lower: (number | null)[]; median: (number | null)[]; upper: (number | null)[] }[]
}

/** Which share of a group's runs had come near enough to the optimum after so many evaluations: it jumps there. */
export interface Reached {
  evaluations: number[]
  shares: number[]
}

/** More points than these cannot be seen. */
const MOST_POINTS = 400
const ROUNDING = 1e-12
/** Values nearer to each other than this share of them are the same. */
export const SAME = 1e-12

/** A quantile of sorted values as the core has it: Hyndman and Fan's type 8. */
export function quantile(sorted: ArrayLike<number>, share: number): number {
  const at = (sorted.length + 1 / 3) * share + 1 / 3
  const place = Math.min(Math.max(Math.floor(at + ROUNDING), 1), sorted.length)
  const [low = NaN, high = low] = [sorted[place - 1], sorted[place]]
  const part = at - place
  // Nothing is added to what may be infinite already.
  return part <= ROUNDING || low === high ? low : low + part * (high - low)
}

/** Where the bands are told: wherever a value changed, or as many places as can be seen, denser at the beginning. */
export function places(curves: readonly (readonly Curve[])[], ends: readonly number[]): number[] {
  const all = new Set<number>(ends)
  for (const group of curves) for (const { evaluations } of group) for (const at of evaluations) all.add(at)
  const sorted = Float64Array.from(all).sort()
  if (sorted.length <= MOST_POINTS) return [...sorted]
  const [first, last] = [sorted[0] ?? 0, sorted.at(-1) ?? 0]
  const half = MOST_POINTS / 2
  const spread = Array.from({ length: half }, (_, k) => [
    first + ((last - first) * k) / (half - 1),
    Math.max(first, 1) * (last / Math.max(first, 1)) ** (k / (half - 1)),
  ])
  return [...new Set([first, ...ends, ...spread.flat().map(Math.round)])].filter((at) => at >= first && at <= last).sort((a, b) => a - b)
}

/** A run without a feasible result yet counts as worse than all others; one that is over keeps its result. */
export function bands(curves: readonly (readonly Curve[])[], ends: readonly number[]): Bands {
  const evaluations = places(curves, ends)
  return { evaluations, groups: curves.map((group, at) => bandOf(group, evaluations, ends[at] ?? 0)) }
}

function bandOf(group: readonly Curve[], evaluations: readonly number[], end: number): Bands['groups'][number] {
  const next = new Uint32Array(group.length)
  const present = new Float64Array(group.length).fill(Infinity)
  const sorted = new Float64Array(group.length)
  const [lower, median, upper]: (number | null)[][] = [[], [], []]
  for (const at of evaluations) {
    group.forEach((curve, run) => {
      let k = next[run] ?? 0
      while (k < curve.evaluations.length && (curve.evaluations[k] ?? 0) <= at) {
        present[run] = curve.values[k] ?? Infinity
        k += 1
      }
      next[run] = k
    })
    sorted.set(present)
    sorted.sort()
    const over = at > end || group.length === 0
    ;[lower, median, upper].forEach((line, quarter) => {
      const value = over ? Infinity : quantile(sorted, (quarter + 1) / 4)
      line?.push(Number.isFinite(value) ? value : null)
    })
  }
  return { lower: lower ?? [], median: median ?? [], upper: upper ?? [] }
}

export function reached(runs: readonly (number | null)[]): Reached {
  const evaluations = runs.filter((at) => at !== null).sort((a, b) => a - b)
  const last = evaluations.flatMap((at, k) => (evaluations[k + 1] === at ? [] : [k]))
  return { evaluations: last.map((k) => evaluations[k] ?? 0), shares: last.map((k) => (k + 1) / runs.length) }
}
