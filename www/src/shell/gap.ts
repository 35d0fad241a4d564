import { en } from '../i18n/en'
import { percent } from '../panels/format'
import type { Yardstick } from '../state/lab.svelte'

/** Two results that differ by rounding alone are equal. */
const ROUNDING = 1e-12

/** How a result stands to the exact optimum. One that cuts through obstacles may be shorter. */
export function compared(gap: number, yardstick: Yardstick): string {
  const optimum = en.result.optimum[yardstick]
  if (Math.abs(gap) < ROUNDING) return en.result.equal(optimum)
  const share = percent(Math.abs(gap))
  return gap > 0 ? en.result.above(share, optimum) : en.result.below(share, optimum)
}
