/* How what carries the page finds what the engine runs on. Each build has one way: the page, a custom element, a file. */

export interface Host {
  /** A new thread: one that hosts a run, one that carries out trials and other tasks, or one that draws. */
  worker(kind: 'run' | 'trial' | 'render'): Worker
  /** The core's first part, compiled; nothing where that fails: who loads it itself then says what is wrong. */
  core(): Promise<WebAssembly.Module | undefined>
}

let present: Host | undefined

/** To be called once, before anything runs. */
export function useHost(host: Host): void {
  present = host
}

export function host(): Host {
  if (!present) throw new Error('nothing says how workers are started')
  return present
}
