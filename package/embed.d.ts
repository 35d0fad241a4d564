/** Where an embedded run is. */
export interface RunState {
  planner: string
  /** The scene's name. */
  scene: string
  seed: number
  iteration: number
  /** The iteration at which it ends at the latest. */
  limit: number
  status: 'running' | 'solved' | 'exhausted' | 'infeasible' | 'failed'
  playing: boolean
  /** The fingerprint of what was computed up to here; empty on the way. */
  hash: string
}

/** What an embedded run posts: it is there; it has come to another iteration; it has ended; something went wrong. */
export type RunEvent = { is: 'ready' | 'step' | 'end'; state: RunState } | { is: 'error'; message: string }

/** What can be posted to it. */
export type RunCommand =
  | { is: 'play' }
  | { is: 'pause' }
  | { is: 'step'; by?: number }
  | { is: 'seek'; to: number }
  | { is: 'open'; link: string }

/** A run in an iframe. */
export interface EmbeddedRun {
  play(): void
  pause(): void
  /** Steps so many iterations on, or back. */
  step(by?: number): void
  /** Goes to an iteration; `Infinity`: to the end. */
  seek(to: number): void
  /** Opens another link: `#v=1&planner=…`. */
  open(link: string): void
  /** Calls `listener` with all that happens, until the returned function is called. */
  listen(listener: (event: RunEvent) => void): () => void
  /** Ends it: nobody is listened to any more. */
  close(): void
}

/**
 * Speaks with the run in an iframe. Only messages of that very frame, from the origin of its address, are listened to, and messages
 * go to that origin only.
 * @param options `origin`: where the frame's page is from, if that is not in its address
 */
export function connect(frame: HTMLIFrameElement, options?: { origin?: string }): EmbeddedRun
