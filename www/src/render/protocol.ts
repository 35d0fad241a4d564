/* What the page and the thread that draws say to each other. Each message is about one canvas. */
import type { Point } from 'forage-lab'
import type { CanvasFiles, Display, Ground, SpaceState } from './display'
import type { Frame } from './frame'
import type { Names } from './looks'

export type ToRenderer = { canvas: number } & (
  | { is: 'open'; element: OffscreenCanvas }
  /** What has changed of what is seen; first all of it. */
  | { is: 'show'; change: Partial<Display> }
  /** The layers that it counts are those of the frame before unless they are given. */
  | { is: 'frame'; frame: Frame; names?: Names }
  | { is: 'ground'; ground: Ground | null }
  /** Gets an `answer`, or is `refused`. */
  | ({ is: 'ask'; id: number } & Asked)
  /** Whether space can be drawn: gets `probed`. */
  | { is: 'probe' }
  /** Where the letters are that all canvases are labelled with: gets `lettered`. */
  | { is: 'letters'; address: string }
  | { is: 'close' }
)

/** A picture or a recording as a file, or a point of it. */
export type Asked =
  /** The name of one of the `CanvasFiles`, and what it is given. */
  { for: keyof CanvasFiles; given: unknown[] } | { for: 'nearest'; at: Point; reach: number; layers: readonly string[] }

export type FromRenderer = { canvas: number } & (
  | { is: 'released'; buffer: ArrayBuffer }
  | { is: 'drawn' }
  | { is: 'closed' }
  | { is: 'probed'; able: boolean }
  | { is: 'lettered' }
  | { is: 'space'; state: SpaceState }
  | Answer
)

export type Answer = { is: 'answer'; id: number; value: unknown } | { is: 'refused'; id: number; message: string }
