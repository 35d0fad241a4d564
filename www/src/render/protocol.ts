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
  | { is: 'close' }
)

export type FromRenderer = { canvas: number } & ({ is: 'released'; buffer: ArrayBuffer } | { is: 'drawn' } | { is: 'closed' })
