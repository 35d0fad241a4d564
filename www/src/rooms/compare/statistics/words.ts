import { number, percent } from '../../../text/number'
import type { Measure } from '../../../render/plot/statistics/scale'

const LEAST = 4
const MOST = 10

/** So many significant digits that values which lie close together can be told apart. */
export function digitsFor(values: readonly number[]): number {
  const finite = values.filter(Number.isFinite)
  const [low, high] = finite.reduce(([a, b], value) => [Math.min(a, value), Math.max(b, value)], [Infinity, -Infinity])
  const size = Math.max(Math.abs(low), Math.abs(high))
  if (!(high > low) || size === 0) return LEAST + 1
  return Math.min(MOST, Math.max(LEAST, Math.ceil(Math.log10(size / (high - low))) + LEAST))
}

export const told = (value: number | null, measure: Measure, digits?: number): string =>
  measure === 'gap' && value !== null ? percent(value) : number(value, digits)

export const probability = (p: number): string => number(p, 3)
