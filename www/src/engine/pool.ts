import { type Remote, wrap } from 'comlink'
import { host } from './host'
import type { TaskApi } from './host/trial-thread'
import { language } from '../locales/language.svelte'
import { HEARTBEAT, UNSTOPPABLE, Watchdog } from './watchdog'

/** Threads without work end after so many milliseconds. */
const PATIENCE = 30_000
/** Steps that take long are not waited for longer than so many milliseconds when they are called off. */
const GRACE = 800

/** A task was called off. */
export class Aborted extends Error {
  override name = 'Aborted'
}

/** A thread with a core of its own. */
export class Thread {
  private readonly worker = host().worker('trial')
  readonly api = wrap<TaskApi>(this.worker)
  private fail: (reason: Error) => void = () => undefined
  private readonly failed = new Promise<never>((_, reject) => {
    this.fail = reject
  })

  constructor() {
    // Somebody waits for it only while a task is carried out.
    this.failed.catch(() => undefined)
    this.worker.onerror = (event) => {
      event.preventDefault()
      this.fail(new Error(event.message || 'worker'))
    }
  }

  private language = 'en'
  private readonly opened = host()
    .files?.()
    .then((files) => this.api.open(files))

  /** `watched`: the thread is ended when it does not answer for seconds. */
  async run<T>(task: Task<T>, watched = false): Promise<T> {
    if (this.opened) await Promise.race([this.opened, this.failed])
    if (this.language !== language.tag) {
      this.language = language.tag
      await Promise.race([this.api.speakIn(language.tag), this.failed])
    }
    if (watched) await Promise.race([this.api.beat(), this.failed])
    const leave = watched ? this.watch() : undefined
    return Promise.race([task(this.api), this.failed]).finally(leave)
  }

  /** Ends the thread when it does not answer any more; returns what to call when that is not awaited. */
  private watch(): () => void {
    const watchdog = new Watchdog(
      () => this.api.beat(),
      () => this.end(new Error(UNSTOPPABLE)),
    )
    const heartbeat = setInterval(() => watchdog.expect(), HEARTBEAT)
    return () => {
      clearInterval(heartbeat)
      watchdog.stop()
    }
  }

  end(reason: Error): void {
    this.worker.terminate()
    this.fail(reason)
  }
}

/** What a thread is to do. */
export type Task<T> = (api: Remote<TaskApi>) => Promise<T>

interface Options {
  /** Somebody's code is carried out in an interpreter: a thread in which it does not end is ended. */
  watched?: boolean
  /** Calls the task off, whether it waits for a thread or has begun. */
  signal?: AbortSignal | undefined
  /** Calls it off while it waits. Once it has begun it comes to its end. */
  waiting?: AbortSignal
}

interface Waiting {
  begin(thread: Thread): Promise<void>
  fail(reason: unknown): void
}

/** Threads that carry out tasks, as many at a time as the machine has cores. */
export class WorkerPool {
  private idle: Thread[] = []
  private busy = 0
  private waiting: Waiting[] = []
  private leaving: ReturnType<typeof setTimeout> | undefined

  constructor(readonly size = Math.max(navigator.hardwareConcurrency || 2, 1)) {}

  /** Carries out a task as soon as there is a thread. Fails with `Aborted`, or with what broke its thread. */
  run<T>(task: Task<T>, options: Options = {}): Promise<T> {
    const { signal, watched = false } = options
    const signals = [signal, options.waiting].filter((one) => one !== undefined)
    return new Promise((resolve, reject) => {
      if (signals.some(({ aborted }) => aborted)) {
        reject(new Aborted())
        return
      }
      const drop = (): void => {
        this.waiting = this.waiting.filter((other) => other !== waiting)
        reject(new Aborted())
      }
      const waiting: Waiting = {
        fail: (reason) => {
          for (const one of signals) one.removeEventListener('abort', drop)
          reject(reason instanceof Error ? reason : new Error(String(reason)))
        },
        begin: async (thread) => {
          for (const one of signals) one.removeEventListener('abort', drop)
          const done = stopWith(thread, signal)
          try {
            resolve(await thread.run(task, watched))
            this.idle.push(thread)
          } catch (error) {
            thread.end(new Aborted())
            reject(error instanceof Error ? error : new Error(String(error)))
          } finally {
            done()
          }
        },
      }
      for (const one of signals) one.addEventListener('abort', drop, { once: true })
      this.waiting.push(waiting)
      this.goOn()
    })
  }

  private goOn(): void {
    clearTimeout(this.leaving)
    while (this.busy < this.size) {
      const next = this.waiting.shift()
      if (!next) break
      try {
        const thread = this.idle.pop() ?? new Thread()
        this.busy += 1
        void next.begin(thread).finally(() => {
          this.busy -= 1
          this.goOn()
        })
      } catch (error) {
        // No thread can be started.
        next.fail(error)
      }
    }
    if (this.busy === 0) this.leaving = setTimeout(() => this.dismiss(), PATIENCE)
  }

  private dismiss(): void {
    for (const thread of this.idle) thread.end(new Aborted())
    this.idle = []
  }
}

/** Stops what a thread does when it is called off; returns what to call when it is over. */
function stopWith(thread: Thread, signal: AbortSignal | undefined): () => void {
  let grace: ReturnType<typeof setTimeout> | undefined
  const stop = (): void => {
    void thread.api.stop()
    grace = setTimeout(() => thread.end(new Aborted()), GRACE)
  }
  signal?.addEventListener('abort', stop, { once: true })
  return () => {
    clearTimeout(grace)
    signal?.removeEventListener('abort', stop)
  }
}

let common: WorkerPool | undefined

/** The threads that all of the page's tasks share. */
export const pool = (): WorkerPool => (common ??= new WorkerPool())
