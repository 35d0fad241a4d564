import type { TraceRows } from '../engine/protocol'

/** Readings of all iterations so far, put together from what each frame adds. */
export class Curve {
  columns: string[] = []
  iterations: number[] = []
  rows: number[] = []

  clear(): void {
    this.columns = []
    this.iterations = []
    this.rows = []
  }

  add({ columns, iterations, rows }: TraceRows): boolean {
    if (iterations.length === 0) return false
    this.columns = columns
    for (const iteration of iterations) this.iterations.push(iteration)
    for (const value of rows) this.rows.push(value)
    return true
  }
}
