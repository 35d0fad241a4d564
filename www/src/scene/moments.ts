/** Rows of numbers, one for each moment of something that takes its time, by name and by time. */
export class Moments {
  readonly times: Float64Array
  private readonly width: number

  constructor(
    readonly columns: readonly string[],
    readonly rows: Float64Array,
  ) {
    this.width = Math.max(1, columns.length)
    this.times = Float64Array.from({ length: Math.floor(rows.length / this.width) }, (_, row) => this.value('time', row))
  }

  get end(): number {
    return this.times.at(-1) ?? 0
  }

  value(name: string, row: number): number {
    const column = this.columns.indexOf(name)
    return column < 0 ? NaN : (this.rows[row * this.width + column] ?? NaN)
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

  /** Two rows that follow each other, and how much of the way between them a time is. */
  protected between(time: number): { from: number; to: number; share: number } {
    const from = this.row(time)
    const to = Math.min(from + 1, this.times.length - 1)
    const [begins, ends] = [this.times[from] ?? 0, this.times[to] ?? 0]
    return { from, to, share: ends > begins ? Math.min(Math.max((time - begins) / (ends - begins), 0), 1) : 0 }
  }

  /** All numbers of a row. */
  values(row: number): Record<string, number> {
    return Object.fromEntries(this.columns.map((name) => [name, this.value(name, row)]))
  }

  csv(): string {
    const lines = Array.from(this.times, (_, row) => Array.from(this.rows.subarray(row * this.width, (row + 1) * this.width)).join(','))
    return `${this.columns.join(',')}\n${lines.join('\n')}\n`
  }
}
