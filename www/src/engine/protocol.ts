import type { Inspection, Outcome, ParameterValue, Point, Point3, RunEvent, Scene, Stage, Status } from 'forage-lab'
import type { FieldPicture, FrameBuffer } from '../render/frame'

/** A refusal of the core as plain data: errors lose their fields on the way between threads. */
export interface Refusal {
  message: string
  /** E.g. `population`, `discs[2].radius`; empty where no field is to blame. */
  field: string
  /** The core refused nothing: a part of it could not be loaded. */
  unloaded?: boolean
}

export type Answer<T> = { ok: true; value: T } | { ok: false; refusal: Refusal }

/** What a new run turned out to be. */
export interface Run {
  generation: number
  planner: string
  scene: Scene
  seed: number
  /** The iteration at which it ends at the latest. */
  limit: number
  span: Span
  parameters: Record<string, ParameterValue>
  exact: { length: number; path: Point[]; tip_path?: Point3[] } | null
}

/** Where a new run starts. */
export interface Opening {
  at: number
  play: boolean
}

/** What is told of a run's state beside the picture: often while it plays, completely when it has settled. */
export interface Report {
  outcome: Outcome
  /** Null before the core has what makes it: that comes after the first picture. */
  link: string | null
  /** Only when the run stands still. */
  settledHash: string | null
}

/** How a result is followed, by the robot or the arm, and the state of the run that it is of. */
export interface Followed<T> {
  told: T | null
  generation: number
  iteration: number
}

export interface TraceRows {
  columns: string[]
  iterations: Float64Array
  rows: Float64Array
}

/** How long a run is, and its parts. */
export interface Span {
  /** The last iteration, as soon as it is known. */
  end: number | null
  /** How many iterations a timeline shows. */
  extent: number
  /** Parts that have their own kind of step; most runs have none. */
  stages: Stage[]
}

export interface FrameMessage extends FrameBuffer {
  type: 'frame'
  generation: number
  /** Who drew it: the span table counts this planner's layers. */
  planner: string
  iteration: number
  computed: number
  status: Status
  playing: boolean
  /** The number of the newest start, seek, play or pause that this is the result of. */
  request: number
  readings: Record<string, number>
  /** The fields that are shown; whoever has drawn them for the last time closes their bitmaps. */
  fields: FieldPicture[]
  trace: TraceRows
  /** What happened in simulated time since the furthest state that was told of. */
  events: RunEvent[]
  /** If it is another one than was told before. */
  span: Span | null
  inspection: Inspection | null
  /** The members' numbers, row by row; null: not asked for, or not again yet. */
  members: Float64Array | null
  report: Report | null
}

/**
 * A step takes long. How far the runs of other planners are that it needs; `done` null: it needs none, nothing is counted; `total` 0:
 * no step takes long any more.
 */
export interface ProgressMessage {
  type: 'progress'
  generation: number
  /** The iteration that the step leads to. */
  step: number
  done: number | null
  total: number
}

/** The core broke down: nothing more comes from this worker. */
export interface CrashMessage {
  type: 'crash'
  message: string
}

export type FromWorker = FrameMessage | ProgressMessage | CrashMessage
export interface ReturnedBuffer {
  buffer: ArrayBuffer
}

/** Iterations a second; Infinity: as fast as it goes. */
export type Speed = number
