import type { Curves } from './curves'

export type Scale = 'linear' | 'log' | 'near'
export type Range = [number, number]

const LOG_FROM = 1e3
/** With a first curve flatter than this share of the whole, nothing could be seen of it. */
const FLAT = 0.15
const ENOUGH = 8
/** Values that differ by less than this share are the same but for rounding. */
const ROUNDING = 1e-9

/**
 * Logarithmic where the values span more than three decades and none of them forbids it; near the best where the
 * other curves would press the first one flat.
 */
export function natural({ values }: Curves): Scale {
  const [low, high] = extent(values)
  if (low > 0 && high / low > LOG_FROM) return 'log'
  const first = (values[0] ?? []).filter((value) => value !== null)
  const [least, most] = extent([first])
  return first.length >= ENOUGH && most - least < FLAT * (high - low) ? 'near' : 'linear'
}

/** Whether a logarithm could show anything. */
export function hasPositive({ values }: Curves): boolean {
  return values.some((curve) => curve.some((value) => value !== null && value > 0))
}

/** The vertical range. `level` is the exact optimum, if it is drawn. */
export function range(curves: Curves, scale: Scale, level: number | null): Range {
  if (scale === 'near') return near(curves, level)
  const curved = level === null ? curves.values : [...curves.values, [level]]
  if (scale === 'log') {
    const [low, high] = extent(curved.map((curve) => curve.filter((value) => value !== null && value > 0)))
    return [low / 1.4, high * 1.4]
  }
  const [low, high] = extent(curved)
  const largest = Math.max(Math.abs(low), Math.abs(high))
  const spread = high - low > ROUNDING * largest ? high - low : largest || 1
  const margin = spread * 0.06
  return [low - margin, high + margin]
}

/** From just below the best that there can be to what the first curve had come down to after a quarter of the way. */
function near({ values }: Curves, level: number | null): Range {
  const best = values[0] ?? []
  const [low] = extent([best])
  const now = best.at(-1) ?? low
  const base = Math.min(level ?? low, low)
  const quarter = best[Math.floor(best.length / 4)] ?? now
  const span = Math.max(quarter - base, 1.5 * (now - base), Math.abs(base) * 1e-4, Number.MIN_VALUE * 1e6)
  return [base - 0.12 * span, base + 1.2 * span]
}

function extent(values: readonly (readonly (number | null)[])[]): Range {
  let [low, high] = [Infinity, -Infinity]
  for (const curve of values) {
    for (const value of curve) {
      if (value === null) continue
      if (value < low) low = value
      if (value > high) high = value
    }
  }
  return low > high ? [0, 1] : [low, high]
}

/** Powers of ten within the range, at most about `most` of them. */
export function decades([low, high]: Range, most: number): number[] {
  const first = Math.ceil(Math.log10(low) - 1e-9)
  const last = Math.floor(Math.log10(high) + 1e-9)
  const stride = Math.max(1, Math.ceil((last - first + 1) / most))
  const splits: number[] = []
  for (let power = Math.ceil(first / stride) * stride; power <= last; power += stride) splits.push(Number(`1e${power}`))
  return splits
}
