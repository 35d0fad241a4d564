import type { CanvasContext, Point, Ramp, Session, Setup } from './forage.js'

export { ModuleDead } from './forage.js'

/** The same members, each with a promise of what it returns. */
export type Asynchronous<T> = {
  readonly [Member in keyof T]: T[Member] extends (...given: infer Given) => infer Result
    ? (...given: Given) => Promise<Result>
    : Promise<T[Member]>
}

/** How a session in a thread is started. */
export interface WorkerOptions {
  /**
   * The thread, if it is not to be made from the package's file: a `Worker` (in Node one of node:worker_threads) whose script imports
   * `forage-lab/session-worker`. It belongs to the session from then on.
   */
  worker?: object
  /** The code of its planner, if that is one of your own: it runs in an interpreter there, see `forage-lab/isolate`. */
  code?: string
  /** The language of its messages, and `locales/….json` of it. English otherwise. */
  words?: { locale: string; patterns: Record<string, string> }
}

/**
 * A session in a thread of its own: it computes while the page goes on. It has the members of `Session`; each returns a promise,
 * getters as well: `await session.iteration`. Calls are answered one after another. What `frame()` brings is a copy: it lasts.
 * What a run needs of the module is loaded by itself. A call that breaks the module down rejects with `ModuleDead`: other sessions
 * have modules of their own, so there is nothing to reset; `free()` this one and start another.
 */
export interface WorkerSession extends Omit<Asynchronous<Session>, 'free' | 'paintField' | typeof Symbol.dispose> {
  /** As of a session: `ctx` is the context of any canvas of the page, which remains there. */
  paintField(ctx: CanvasContext, min: Point, max: Point, ramp?: Ramp): Promise<boolean>
  /** Ends the thread at once, even within a call. Calls that wait for an answer, and later ones, are refused. */
  free(): void
  [Symbol.dispose](): void
}

export const WorkerSession: {
  /**
   * Starts a run at iteration 0, in a thread of its own. It rejects for what is refused, as the constructor of `Session` does, and
   * where the thread cannot be started.
   */
  start(setup: Setup, options?: WorkerOptions): Promise<WorkerSession>
  /** The same for the run that a link describes, at iteration 0. */
  fromLink(link: string, options?: WorkerOptions): Promise<WorkerSession>
  [Symbol.hasInstance](value: unknown): value is WorkerSession
}
