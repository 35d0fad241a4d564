import { isWatched, type RunSetup } from '../catalogue/own'
import type { Item, TrialRecord } from 'forage-lab'
import { pool } from './pool'
import type { Report } from './protocol'
import { RunClient } from './run-client'
import type { Ending, Errand } from './trial.protocol'

/** What a run is like at an iteration, with the explanation of an item. */
export type Look = Pick<Report, 'inspection' | 'readings' | 'outcome' | 'iteration' | 'evaluations'>

interface Waiting {
  version: number
  resolve(report: Report): void
  reject(reason: Error): void
}

/** A run that nobody sees: for what is to be known of other iterations than the one that is shown. */
export class SideRun {
  private waiting: Waiting | null = null
  /** Questions one after the other. */
  private queue: Promise<unknown> = Promise.resolve()
  private opened = false
  private readonly stopped = new AbortController()

  private readonly client = new RunClient({
    onreport: (report) => this.receive(report),
    onrefused: ({ message }, version) => this.fail(message, version),
    onprogress: () => undefined,
    onopen: () => undefined,
    onbroken: (message) => this.fail(message),
    onreplaced: () => undefined,
  })

  /** A run at an iteration, or where it ended before. Fails with what the setup is refused for. */
  at(setup: RunSetup, iteration: number, item: Item | null): Promise<Look> {
    const asked = this.queue.then(() => this.look(setup, iteration, item))
    this.queue = asked.catch(() => undefined)
    return asked
  }

  private async look(setup: RunSetup, at: number, item: Item | null): Promise<Look> {
    const report = await this.goTo(setup, at)
    if (!item) return { ...report, inspection: null }
    const answer = await this.client.api.inspect(item)
    if (!answer.ok) throw new Error(answer.refusal.message)
    return { ...report, inspection: answer.value }
  }

  private goTo(setup: RunSetup, at: number): Promise<Report> {
    return new Promise((resolve, reject) => {
      if (!this.opened) void this.client.open()
      this.opened = true
      const version = this.client.want({ start: { setup, at, play: false }, underway: false })
      this.waiting = { version, resolve, reject }
    })
  }

  private receive(report: Report): void {
    const { waiting } = this
    this.client.giveBack(report.frame.buffer)
    if (!waiting || report.version < waiting.version || !report.arrived) return
    this.waiting = null
    waiting.resolve(report)
  }

  private fail(message: string, version = Number.POSITIVE_INFINITY): void {
    const { waiting } = this
    if (!waiting || version < waiting.version) return
    this.waiting = null
    waiting.reject(new Error(message))
  }

  /** The nearest piece that can be explained, in the run that was asked for last. */
  pick(x: number, y: number, reach: number): Promise<Item | null> {
    return this.client.api.pick(x, y, reach)
  }

  /** Whole runs with the seeds 1, 2, 3, …; with `evaluations` none goes on beyond those. */
  trials(setup: RunSetup, seeds: number, evaluations: number | null): Promise<TrialRecord[]> {
    const runs = Array.from({ length: seeds }, async (_, at): Promise<TrialRecord> => {
      const errand: Errand = { key: '', seed: at + 1, setup: { ...setup, seed: at + 1 }, maps: null, budget: evaluations, most: null }
      const ending = await pool().run<Ending>((api) => api.run(errand), {
        signal: this.stopped.signal,
        watched: isWatched(setup),
      })
      if (ending.is === 'over') return ending.row.record
      throw new Error(ending.is === 'refused' ? ending.refusal.message : ending.is === 'broken' ? ending.message : 'stopped')
    })
    return Promise.all(runs)
  }

  close(): void {
    this.stopped.abort()
    this.client.close()
    this.fail('closed')
  }
}
