import { isWatched } from '../catalogue/own'
import { Aborted, pool } from './pool'
import type { Ending, Errand } from './trial.protocol'

/** So many breakdowns one after the other are no accident. */
const MOST_BREAKDOWNS = 3

interface Work {
  /** The next run that nobody has begun; null: there is none. */
  next(): Errand | null
  over(errand: Errand, ending: Ending): void
  /** Nothing runs any more. */
  rested(): void
}

/** Carries out runs side by side. Their results don't depend on how many threads there are. */
export class Trials {
  /** What is carried out, and how to call it off. */
  private readonly running = new Map<Errand, AbortController>()
  private stopping = false
  private breakdowns = 0

  constructor(private readonly work: Work) {}

  /** Takes up what there is to do. Also to be called when there is more than before. */
  start(): void {
    this.stopping = false
    this.breakdowns = 0
    this.fill()
  }

  /** Calls off what is being done. */
  stop(): void {
    this.stopping = true
    for (const controller of this.running.values()) controller.abort()
  }

  /** Calls off runs that nobody wants any more; others take their place. */
  recall(wanted: (errand: Errand) => boolean): void {
    for (const [errand, controller] of this.running) if (!wanted(errand)) controller.abort()
  }

  private fill(): void {
    while (!this.stopping && this.running.size < pool().size) {
      const errand = this.work.next()
      if (!errand) break
      void this.carryOut(errand)
    }
    if (this.running.size === 0) this.work.rested()
  }

  private async carryOut(errand: Errand): Promise<void> {
    const controller = new AbortController()
    this.running.set(errand, controller)
    const ending = await pool()
      .run<Ending>((api) => api.run(errand), { signal: controller.signal, watched: isWatched(errand.setup) })
      .catch((error: Error): Ending => (error instanceof Aborted ? { is: 'stopped' } : { is: 'broken', message: error.message }))
    this.running.delete(errand)
    this.work.over(errand, ending)
    this.breakdowns = ending.is === 'broken' ? this.breakdowns + 1 : 0
    if (this.breakdowns >= MOST_BREAKDOWNS) this.stop()
    this.fill()
  }
}
