import { punctuation } from '../../../locales/en/punctuation'
import { number, superscript } from '../../../text/number'
import { decades as powers } from '../scale'

export type Measure = 'value' | 'gap'
export type ValueScale = 'linear' | 'log'

/** Gaps by rounding alone are none. */
const ROUNDING = 1e-12
const inMeasure = (text: string, measure: Measure): string => (measure === 'gap' ? punctuation.percent(text) : text)

export const isPositive = (value: number, measure: Measure): boolean => value > (measure === 'gap' ? ROUNDING : 0)

/** How values become places on an axis: the axis itself is linear, what is logarithmic are the numbers. */
export interface Axis {
  /** Where a value is. */
  place(value: number): number
  range: [number, number]
  /** Places with labels, where the plot doesn't choose them, if there is room for so many. */
  splits?(most: number): number[]
  label(place: number, step: number): string
}

const FEW_DECADES = 3
const MARGIN = 0.04
/** Shown on both sides of a gap that all share. */
const LEAST_GAP = 0.01

function extent(values: readonly number[]): [number, number] {
  let [low, high] = [Infinity, -Infinity]
  for (const value of values) {
    low = Math.min(low, value)
    high = Math.max(high, value)
  }
  return low > high ? [0, 1] : [low, high]
}

/** A power of ten, or what is between two of them. */
function powerLabel(power: number): string {
  if (power >= -3 && power <= 4) return String(Number((10 ** power).toPrecision(3)))
  return Number.isInteger(power) ? `10${superscript(power)}` : number(10 ** power, 3)
}

/** As many decimals as the distance of the labels needs. */
export function decimals(value: number, step: number): string {
  const size = Math.abs(value)
  if (step <= 0 || size >= 1e6 || step < 1e-7) return number(value, 3)
  let places = Math.max(0, -Math.floor(Math.log10(step) + 1e-9))
  if (Math.abs(step * 10 ** places - Math.round(step * 10 ** places)) > 1e-6) places += 1
  return `${value < 0 ? '−' : ''}${size.toFixed(places)}`
}

export function linear(values: readonly number[], measure: Measure): Axis {
  const [low, high] = extent(values)
  const margin = (high - low || Math.abs(high) || (measure === 'gap' ? LEAST_GAP : 1)) * MARGIN
  return {
    place: (value) => (measure === 'gap' ? 100 * value : value),
    range: [low - margin, high + margin].map((value) => (measure === 'gap' ? 100 * value : value)) as [number, number],
    label: (place, step) => inMeasure(decimals(place, step), measure),
  }
}

/** Zero, and what is below, lies a decade below the smallest positive value. */
export function logarithmic(values: readonly number[], measure: Measure): Axis {
  const [low, high] = extent(values.filter((value) => isPositive(value, measure)))
  const floor = values.some((value) => !isPositive(value, measure)) ? Math.floor(Math.log10(low)) - 1 : null
  const from = floor ?? Math.log10(low)
  const to = Math.log10(high)
  const margin = (to - from || 1) * MARGIN
  const decades = (most: number): number[] => {
    const [first, last] = [Math.ceil((floor === null ? from : floor + 1) - margin), Math.floor(to + margin)]
    const stride = Math.max(1, Math.ceil((last - first + 1) / Math.max(1, most)))
    const powers = Array.from({ length: Math.max(0, Math.ceil((last - first + 1) / stride)) }, (_, k) => first + k * stride)
    // Few powers of ten may leave room for numbers between them; within one decade there may be none at all.
    const between =
      powers.length <= FEW_DECADES ? [first - 1, ...powers].flatMap((power) => [power + Math.log10(2), power + Math.log10(5)]) : []
    const inside = [...powers, ...between].filter((at) => at > (floor ?? from - margin) && at < to + margin)
    const fitting = inside.length <= most ? inside : powers
    const shown = fitting.length > 1 ? fitting : [from, (from + to) / 2, to]
    return [...(floor === null ? [] : [floor]), ...shown.toSorted((a, b) => a - b)]
  }
  return {
    place: (value) => (isPositive(value, measure) ? Math.log10(value) : (floor ?? from - margin)),
    range: [from - margin, to + margin],
    splits: decades,
    label: (place) => {
      if (place === floor) return inMeasure('0', measure)
      const power = measure === 'gap' ? place + 2 : place
      return inMeasure(powerLabel(power), measure)
    },
  }
}

export const axisOf = (scale: ValueScale, values: readonly number[], measure: Measure): Axis =>
  (scale === 'log' ? logarithmic : linear)(values, measure)

/** Values on one of the scales of a run's own charts, over this range. */
export function axisOn(scale: 'linear' | 'log' | 'near', [low, high]: readonly [number, number]): Axis {
  if (scale !== 'log') return { place: (value) => value, range: [low, high], label: decimals }
  return {
    place: (value) => (value > 0 ? Math.log10(value) : NaN),
    range: [Math.log10(low), Math.log10(high)],
    splits: (most) => powers([low, high], most).map((value) => Math.log10(value)),
    label: powerLabel,
  }
}

/** Iterations or evaluations from nought on. */
export const countAxis = (last: number): Axis => ({
  place: (at) => at,
  range: [0, Math.max(1, last)],
  label: (at) => (Number.isInteger(at) ? number(at) : ''),
})

/** Evaluations: from nought, or from the first on by their logarithm. */
export function evaluationAxis(scale: ValueScale, first: number, last: number): Axis {
  if (scale === 'linear') return countAxis(last)
  const [from, to] = [Math.log10(Math.max(1, first)), Math.log10(Math.max(10, last))]
  return {
    place: (at) => Math.log10(Math.max(1, at)),
    range: [Math.min(from, to - 0.5), to],
    splits: () => Array.from({ length: Math.floor(to) - Math.ceil(from) + 1 }, (_, k) => Math.ceil(from) + k),
    label: (at) => number(Math.round(10 ** at)),
  }
}
