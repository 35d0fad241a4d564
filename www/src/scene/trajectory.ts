import type { Motion, Point3 } from 'forage-lab'
import { Moments } from './moments'

/** The joints' names in rows, from the base to the wrist. */
export const JOINTS = ['q1', 'q2', 'q3', 'q4', 'q5', 'q6'] as const
const TIP = ['x', 'y', 'z'] as const

/** The rows of an arm's motion. */
export class Swing extends Moments {
  constructor(readonly motion: Motion) {
    super(motion.columns, motion.rows)
  }

  /** Between two rows all joints turn evenly; in degrees. Null where there are no rows. */
  postureAt(time: number): number[] | null {
    if (this.times.length === 0) return null
    const { from, to, share } = this.between(time)
    return JOINTS.map((name) => this.value(name, from) * (1 - share) + this.value(name, to) * share)
  }

  /** Where the tip is, to within what it goes from one row to the next. */
  tipAt(time: number): Point3 | null {
    if (this.times.length === 0) return null
    const { from, to, share } = this.between(time)
    const [x = 0, y = 0, z = 0] = TIP.map((name) => this.value(name, from) * (1 - share) + this.value(name, to) * share)
    return [x, y, z]
  }

  /** The time of the row before or after a time. */
  neighbour(time: number, onwards: boolean): number {
    const row = this.row(time)
    if (onwards) return this.times[row + 1] ?? this.end
    return this.times[(this.times[row] ?? 0) < time ? row : row - 1] ?? 0
  }
}
