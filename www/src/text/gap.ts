import { common } from '../locales/en/common'
import { percent } from './number'

/** Two results that differ by rounding alone are equal. */
const ROUNDING = 1e-12

/** How a result stands to the exact optimum. One that cuts through obstacles may be shorter. */
export function compared(gap: number, optimum: string): string {
  if (Math.abs(gap) < ROUNDING) return common.result.equal(optimum)
  const share = percent(Math.abs(gap))
  return gap > 0 ? common.result.above(share, optimum) : common.result.below(share, optimum)
}
