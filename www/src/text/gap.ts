import { en } from '../locales/en/page'
import { percent } from './number'

/** Two results that differ by rounding alone are equal. */
const ROUNDING = 1e-12

/** How a result stands to the exact optimum. One that cuts through obstacles may be shorter. */
export function compared(gap: number, optimum: string): string {
  if (Math.abs(gap) < ROUNDING) return en.result.equal(optimum)
  const share = percent(Math.abs(gap))
  return gap > 0 ? en.result.above(share, optimum) : en.result.below(share, optimum)
}
