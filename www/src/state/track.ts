import type { Drive } from 'forage'

export interface Pose {
  x: number
  y: number
  /** Radians. */
  heading: number
}

/** A drive's rows by name and by time. */
export class Track {
  readonly times: Float64Array
  private readonly width: number

  constructor(readonly drive: Drive) {
    this.width = Math.max(1, drive.columns.length)
    this.times = Float64Array.from({ length: Math.floor(drive.rows.length / this.width) }, (_, row) => this.value('time', row))
  }

  get end(): number {
    return this.times.at(-1) ?? 0
  }

  value(name: string, row: number): number {
    const column = this.drive.columns.indexOf(name)
    return column < 0 ? NaN : (this.drive.rows[row * this.width + column] ?? NaN)
  }

  /** The last row that isn't after a time. */
  row(time: number): number {
    let [low, high] = [0, this.times.length - 1]
    while (low < high) {
      const middle = (low + high + 1) >> 1
      if ((this.times[middle] ?? 0) <= time) low = middle
      else high = middle - 1
    }
    return low
  }

  /** All numbers of a row. */
  values(row: number): Record<string, number> {
    return Object.fromEntries(this.drive.columns.map((name) => [name, this.value(name, row)]))
  }

  pose(row: number): Pose {
    return { x: this.value('x', row), y: this.value('y', row), heading: this.value('heading', row) }
  }

  /** Between two rows the robot goes straight on. */
  at(time: number): Pose {
    const row = this.row(time)
    const [from, to] = [this.pose(row), this.pose(Math.min(row + 1, this.times.length - 1))]
    const [begins, ends] = [this.times[row] ?? 0, this.times[row + 1] ?? 0]
    const share = ends > begins ? Math.min(Math.max((time - begins) / (ends - begins), 0), 1) : 0
    const turn = Math.atan2(Math.sin(to.heading - from.heading), Math.cos(to.heading - from.heading))
    return { x: from.x + (to.x - from.x) * share, y: from.y + (to.y - from.y) * share, heading: from.heading + turn * share }
  }

  csv(): string {
    const { columns, rows } = this.drive
    const lines = Array.from(this.times, (_, row) => Array.from(rows.subarray(row * this.width, (row + 1) * this.width)).join(','))
    return `${columns.join(',')}\n${lines.join('\n')}\n`
  }
}
