import type { Outcome, ParameterValue, Point, Point3, Scene, Status, TrialCurve } from 'forage-lab'
import type { FieldPicture, FrameBuffer } from '../render/frame'

/** What a racer's run turned out to be. */
export interface Start {
  planner: string
  scene: Scene
  seed: number
  parameters: Record<string, ParameterValue>
  exact: { length: number; path: Point[]; tip_path?: Point3[] } | null
  /** Evaluations before the first step. */
  first: number
  /** The most evaluations of one of its first steps. */
  most: number
  /** The iteration at which it ends at the latest. */
  limit: number
  /** An arm at home: base, shoulder, elbow, wrist and tip. */
  skeleton: Point3[]
}

/** How far a racer has come at its furthest. */
export interface Furthest {
  iteration: number
  evaluations: number
  limit: number
  /** The most evaluations of one step. */
  most: number
  /** There is nothing beyond. */
  ended: boolean
  /** Its last steps evaluated nothing: they are beyond its last evaluation. */
  tail: boolean
}

/** A racer at a time of the race's clock. */
export interface Picture extends FrameBuffer {
  iteration: number
  evaluations: number
  status: Status
  furthest: Furthest
  fields: FieldPicture[]
  /** Told when it has grown. */
  curve: TrialCurve | null
  /** Costs more than a picture: while it goes on it is told a few times a second. */
  outcome: Outcome | null
}

/** A racer that stands still. */
export interface Settled {
  iteration: number
  outcome: Outcome
  hash: string
  link: string
}
