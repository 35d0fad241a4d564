import type { Drive } from 'forage-lab'
import { Moments } from './moments'

export interface Pose {
  x: number
  y: number
  /** Radians. */
  heading: number
}

/** A drive's rows. */
export class Track extends Moments {
  constructor(readonly drive: Drive) {
    super(drive.columns, drive.rows)
  }

  pose(row: number): Pose {
    return { x: this.value('x', row), y: this.value('y', row), heading: this.value('heading', row) }
  }

  /** Between two rows the robot goes straight on. */
  at(time: number): Pose {
    const between = this.between(time)
    const [from, to, { share }] = [this.pose(between.from), this.pose(between.to), between]
    const turn = Math.atan2(Math.sin(to.heading - from.heading), Math.cos(to.heading - from.heading))
    return { x: from.x + (to.x - from.x) * share, y: from.y + (to.y - from.y) * share, heading: from.heading + turn * share }
  }
}
