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

/** Readings as they were at one moment. */
export interface History {
  columns: readonly string[]
  iterations: readonly number[]
  rows: readonly number[]
}

/** As they are now: the arrays grow in place, and are emptied for another run. */
export const historyOf = ({ columns, iterations, rows }: History): History => ({
  columns: [...columns],
  iterations: [...iterations],
  rows: [...rows],
})
