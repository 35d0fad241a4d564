import type { Parameter } from 'forage-lab'

/** How a slider's positions stand for a parameter's values: native range attributes and the two ways. */
export interface Slider {
  min: number
  max: number
  step: number
  /** The position nearest to a value, which may lie beyond the slider's ends. */
  position(value: number): number
  value(position: number): number
}

const LOG_POSITIONS = 200
const STEPS = 200

/** Nothing for parameters that aren't numbers or have no end to slide to. */
export function slider(parameter: Parameter): Slider | undefined {
  const low = parameter.soft_min ?? parameter.min
  const high = parameter.soft_max ?? parameter.max
  if (low === undefined || high === undefined || !(high > low)) return undefined
  const whole = parameter.type === 'integer'
  if (parameter.logarithmic && low > 0) return logarithmic(low, high, whole)
  const step = parameter.step || (whole ? Math.max(1, nice((high - low) / STEPS)) : nice((high - low) / STEPS))
  return {
    min: low,
    max: high,
    step,
    position: (value) => clamp(value, low, high),
    value: (position) => tidy(position),
  }
}

/** Positions are even steps of the logarithm; values in between are rounded to what one would have typed. */
function logarithmic(low: number, high: number, whole: boolean): Slider {
  const span = Math.log(high / low)
  return {
    min: 0,
    max: LOG_POSITIONS,
    step: 1,
    position: (value) => (LOG_POSITIONS * Math.log(clamp(value, low, high) / low)) / span,
    value: (position) => {
      if (position <= 0) return low
      if (position >= LOG_POSITIONS) return high
      const value = low * Math.exp((span * position) / LOG_POSITIONS)
      const rounded = Number(value.toPrecision(2))
      return clamp(whole ? Math.round(rounded) : rounded, low, high)
    },
  }
}

function clamp(value: number, low: number, high: number): number {
  return Math.min(Math.max(value, low), high)
}

/** 1, 2 or 5 times a power of ten, at most `size`. */
function nice(size: number): number {
  const power = 10 ** Math.floor(Math.log10(size))
  const lead = size / power
  return tidy((lead >= 5 ? 5 : lead >= 2 ? 2 : 1) * power)
}

/** Without the dust of binary fractions. */
function tidy(value: number): number {
  return Number(value.toPrecision(12))
}

/** A typed number; `undefined` if it isn't one. */
export function typed(text: string): number | undefined {
  const plain = text.trim().replace('−', '-')
  return /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(plain) ? Number(plain) : undefined
}
