import type { Catalogue } from 'forage-lab'

/* How what carries the page finds what the engine runs on. Each build has one way: the page, a custom element, a file. */

/** Addresses of the page, for iframes, and of the element's script. */
export interface Elsewhere {
  page: string
  element: string
}

/** Files of the package by their names, as bytes: threads of a page from a disk cannot read blobs everywhere. */
export type Files = Readonly<Record<string, ArrayBuffer>>

export interface Host {
  /** A new thread: one that hosts a run, one that carries out trials and other tasks, or one that draws. */
  worker(kind: 'run' | 'trial' | 'render'): Worker
  /** The core's first part, compiled; nothing where that fails: who loads it itself then says what is wrong. */
  core(): Promise<WebAssembly.Module | undefined>
  /** What there is to choose from: known before any of the core is loaded. */
  catalogue(): Promise<Catalogue>
  /** Where others find what shows a run on their pages. */
  readonly elsewhere?: Elsewhere
  /** The page in one file, to be saved with a run. */
  singleFile?(): Promise<string>
  /** The package's files, by their names, where threads cannot find them by themselves. */
  files?(): Promise<Files>
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
