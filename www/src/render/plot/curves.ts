/** Readings of the past, as the core's trace has them: row by row. */
export interface History {
  columns: readonly string[]
  iterations: ArrayLike<number>
  rows: ArrayLike<number>
}

/** The same by column, thinned to what a chart can show. `null` is a gap. */
export interface Curves {
  iterations: number[]
  /** One for each name asked for. */
  values: (number | null)[][]
}

const MOST_POINTS = 1500

/** The curves of `names`. The first and the last iteration are always among the points. */
export function curves({ columns, iterations, rows }: History, names: readonly string[]): Curves {
  const count = Math.min(iterations.length, columns.length > 0 ? Math.floor(rows.length / columns.length) : 0)
  const stride = Math.max(1, Math.ceil(count / MOST_POINTS))
  const kept: number[] = []
  for (let row = 0; row < count; row += stride) kept.push(row)
  if (count > 0 && kept.at(-1) !== count - 1) kept.push(count - 1)
  return {
    iterations: kept.map((row) => iterations[row] ?? 0),
    values: names.map((name) => {
      const column = columns.indexOf(name)
      return kept.map((row) => (column < 0 ? null : finite(rows[row * columns.length + column])))
    }),
  }
}

function finite(value: number | undefined): number | null {
  return value !== undefined && Number.isFinite(value) ? value : null
}

/** Where `iteration` is in the curves: the last point that isn't after it. */
export function pointAt({ iterations }: Curves, iteration: number): number {
  let low = 0
  let high = iterations.length - 1
  while (low < high) {
    const middle = (low + high + 1) >> 1
    if ((iterations[middle] ?? 0) <= iteration) low = middle
    else high = middle - 1
  }
  return low
}

/** About `count` points, evenly spread, for a table. */
export function sample(length: number, count: number): number[] {
  if (length <= count) return Array.from({ length }, (_, at) => at)
  return Array.from({ length: count }, (_, at) => Math.round((at * (length - 1)) / (count - 1)))
}

/** The first of the curves at these iterations: each value holds until the next; beyond its end there is none. */
export function sampled(of: Curves, iterations: readonly number[]): (number | null)[] {
  const [values = []] = of.values
  const [first = 0, last = 0] = [of.iterations[0], of.iterations.at(-1)]
  return iterations.map((at) => (at < first || at > last ? null : (values[pointAt(of, at)] ?? null)))
}
