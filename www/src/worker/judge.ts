import type { Outcome, Status, TrialCurve } from 'forage-lab'

/** What a judge must be able to ask a run. */
interface Judged {
  readonly iteration: number
  readonly evaluations: number
  readonly status: Status
  readings(): Record<string, number>
  outcome(): Outcome
}

/** Keeps a run's feasible best whenever it changes, as a trial does. A trial of its own would take every step twice. */
export class Judge {
  private readonly iterations: number[] = []
  private readonly evaluations: number[] = []
  private readonly values: number[] = []
  private told = ''
  private seen: number | null = null

  get changes(): number {
    return this.values.length
  }

  /** To be asked after each step. To ask for an outcome takes longer than most steps: only when the readings say that there may be another. */
  look(run: Judged): void {
    const { best, length, final_length: final } = run.readings()
    // A drive is judged at its end.
    const telling = [best, length, final, best === undefined && run.status].join()
    if (telling === this.told) return
    this.told = telling
    const { feasible, length: long, cost } = run.outcome()
    if (cost === null || cost === this.seen) return
    this.seen = cost
    if (!feasible) return
    this.iterations.push(run.iteration)
    this.evaluations.push(run.evaluations)
    this.values.push(long ?? cost)
  }

  curve(): TrialCurve {
    return {
      iterations: Float64Array.from(this.iterations),
      evaluations: Float64Array.from(this.evaluations),
      values: Float64Array.from(this.values),
    }
  }
}
