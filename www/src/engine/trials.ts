import * as Comlink from 'comlink'
import { host } from './host'
import type { TaskApi } from './host/trial.worker'
import type { Ending, Errand } from './trial.protocol'

/** Threads without work leave after so many milliseconds. */
const PATIENCE = 30_000
/** Steps that take long are not waited for longer than so many milliseconds when they are called off. */
const GRACE = 800
/** So many breakdowns one after the other are no accident. */
const MOST_BREAKDOWNS = 3

/** Another thread with a core of its own. */
export class Thread {
  private readonly worker = host().worker('trial')
  readonly api = Comlink.wrap<TaskApi>(this.worker)
  private fail: (problem: Error) => void = () => undefined
  ended = false
  private readonly failed = new Promise<never>((_, reject) => {
    this.fail = reject
    this.worker.onerror = (event) => {
      event.preventDefault()
      reject(new Error(event.message || 'worker'))
    }
  })

  constructor() {
    // Somebody waits for it only while a question is open.
    this.failed.catch(() => undefined)
  }

  /** What it answers, or why it cannot any more. */
  ask<T>(answer: Promise<T>): Promise<T> {
    return Promise.race([answer, this.failed])
  }

  /** Whatever it was asked will not be answered. */
  end(): void {
    this.ended = true
    this.worker.terminate()
    this.fail(new Error('ended'))
  }
}

interface Work {
  /** The next run that nobody has begun; null: there is none. */
  next(): Errand | null
  over(errand: Errand, ending: Ending): void
  /** Nobody works any more. */
  rested(): void
}

/** Carries out runs side by side. What they come to doesn't depend on how many threads there are. */
export class Trials {
  private idle: Thread[] = []
  /** What each is at. */
  private readonly busy = new Map<Thread, Errand>()
  private stopping = false
  private breakdowns = 0
  private leaving: ReturnType<typeof setTimeout> | undefined
  private grace: ReturnType<typeof setTimeout> | undefined

  constructor(
    private readonly size: number,
    private readonly work: Work,
  ) {}

  /** Takes up what there is to do. Also to be called when there is more than before. */
  start(): void {
    this.stopping = false
    this.breakdowns = 0
    clearTimeout(this.leaving)
    clearTimeout(this.grace)
    this.staff()
  }

  /** Calls off what is being done. */
  stop(): void {
    this.stopping = true
    for (const thread of this.busy.keys()) void thread.api.stop()
    clearTimeout(this.grace)
    this.grace = setTimeout(() => {
      for (const thread of this.busy.keys()) thread.end()
    }, GRACE)
  }

  /** Calls off runs that nobody wants any more; their threads go on with others. */
  recall(wanted: (errand: Errand) => boolean): void {
    for (const [thread, errand] of this.busy) {
      if (wanted(errand)) continue
      void thread.api.stop()
      setTimeout(() => {
        if (this.busy.get(thread) === errand) thread.end()
      }, GRACE)
    }
  }

  private staff(): void {
    while (!this.stopping && this.busy.size < this.size) {
      const errand = this.work.next()
      if (!errand) break
      const thread = this.idle.pop() ?? new Thread()
      void this.keepBusy(thread, errand)
    }
    if (this.busy.size === 0) this.rest()
  }

  private async keepBusy(thread: Thread, first: Errand): Promise<void> {
    for (let errand: Errand | null = first; errand && !this.stopping; errand = this.stopping ? null : this.work.next()) {
      this.busy.set(thread, errand)
      const ending = await thread
        .ask<Ending>(thread.api.run(errand))
        .catch(
          (error: unknown): Ending =>
            thread.ended ? { is: 'stopped' } : { is: 'broken', message: error instanceof Error ? error.message : String(error) },
        )
      this.work.over(errand, ending)
      if (ending.is === 'broken' || thread.ended) {
        thread.end()
        this.busy.delete(thread)
        if (ending.is === 'broken') this.breakdowns += 1
        if (this.breakdowns >= MOST_BREAKDOWNS) this.stop()
        this.staff()
        return
      }
      this.breakdowns = 0
    }
    this.busy.delete(thread)
    this.idle.push(thread)
    if (this.busy.size === 0) this.rest()
  }

  private rest(): void {
    clearTimeout(this.leaving)
    clearTimeout(this.grace)
    this.leaving = setTimeout(() => {
      for (const thread of this.idle) thread.end()
      this.idle = []
    }, PATIENCE)
    this.work.rested()
  }
}
