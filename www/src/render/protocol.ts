/* What the page and the thread that draws say to each other. Each message is about one canvas. */
import type { Display, Ground } from './display'
import type { Frame } from './frame'
import type { Names } from './looks'

export type ToRenderer = { canvas: number } & (
  | { is: 'open'; element: OffscreenCanvas }
  /** What has changed of what is seen; first all of it. */
  | { is: 'show'; change: Partial<Display> }
  /** The layers that it counts are those of the frame before unless they are given. */
  | { is: 'frame'; frame: Frame; names?: Names }
  | { is: 'ground'; ground: Ground | null }
  /** Is answered by `made` or `failed`. */
  | ({ is: 'make'; id: number } & Wanted)
  | { is: 'close' }
)

/** A picture as a file. */
export type Wanted = { as: 'svg'; caption: string } | { as: 'picture'; density: number }

export type FromRenderer = { canvas: number } & ({ is: 'released'; buffer: ArrayBuffer } | { is: 'drawn' } | { is: 'closed' } | Made)

export type Made = { is: 'made'; id: number; file: string | Blob } | { is: 'failed'; id: number; message: string }
