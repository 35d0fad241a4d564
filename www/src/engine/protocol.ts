/* What crosses between the host of a run and the client that shows it. */
import type { RunSetup } from '../catalogue/own'
import type { Files } from './host'
import type {
  Finding,
  Inspection,
  Item,
  Job,
  Outcome,
  ParameterValue,
  Point,
  Point3,
  RunEvent,
  Scene,
  Stage,
  Status,
  TrialCurve,
} from 'forage-lab'
import type { Frame, Viewport } from '../render/frame'

/** A refusal of the core as plain data: errors lose their fields on the way between threads. */
export interface Refusal {
  message: string
  /** E.g. `population`, `discs[2].radius`; empty where no field is to blame. */
  field: string
  /** Where a planner's code is wrong, from 1. */
  line?: number
  column?: number
  /** Why code was stopped. */
  stopped?: 'time' | 'memory'
  /** The core refused nothing: a part of it could not be loaded. */
  unloaded?: boolean
}

export type Answer<T> = { ok: true; value: T } | { ok: false; refusal: Refusal }

/** What places of a run are measured in. */
export type ClockUnit = 'iterations' | 'evaluations'

/** Iterations a second; Infinity: as fast as it goes. */
export type Speed = number

/** A run that is wanted, and where it begins. */
export interface Start {
  setup: RunSetup
  at: number
  play: boolean
  /** It is said that the setup is accepted before the run begins, which may take long. */
  check?: boolean
}

/** Where a run begins. */
export type Opening = Omit<Start, 'setup'>

/** Where a run is to go. */
export interface Target {
  /** Where it goes first: the first iteration at or beyond this place; absent: it stays where it is. */
  at?: number
  /** From there it goes on to its end. */
  play: boolean
}

/** One of the suppositions of an explanation, and the number of the other random numbers. */
export interface Supposition {
  name: string
  draw: number
}

/** All that is wanted of a host: it converges to the newest. */
export interface Desired {
  start: Start | null
  /** Where the run goes, if that was wanted after it was started. */
  target: Target | null
  clock: ClockUnit
  speed: Speed
  /** The item of the picture that is explained. */
  item: Item | null
  /** What is supposed otherwise in its step. */
  supposition: Supposition | null
  viewport: Viewport
  /** Reports bring the members' numbers at most so often, in milliseconds; null: never. */
  members: number | null
  /** Reports come on the way to a place, too. */
  underway: boolean
  /** Where it stays, the run is summed up: outcome, link and hash. */
  summary: boolean
  /** Summaries have links. Those need a part of the core. */
  links: boolean
  /** Vertices a layer may have. */
  budget: number
  /** The language of what the core says. */
  language: string
}

/** What nobody has wanted otherwise. A canvas draws so many vertices in a few tens of milliseconds. */
export const DEFAULTS: Desired = {
  start: null,
  target: null,
  clock: 'iterations',
  speed: 30,
  item: null,
  supposition: null,
  viewport: { fields: [], window: null },
  members: null,
  underway: true,
  summary: true,
  links: false,
  budget: 100_000,
  language: 'en',
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

/** What a new run turned out to be. */
export interface Run {
  /** Grows with each run. */
  generation: number
  planner: string
  scene: Scene
  seed: number
  /** The iteration at which it ends at the latest. */
  limit: number
  span: Span
  parameters: Record<string, ParameterValue>
  exact: { length: number; path: Point[]; tip_path?: Point3[] } | null
  /** An arm at home: base, shoulder, elbow, wrist and tip; empty for others. */
  skeleton: Point3[]
  /** Evaluations before the first step. */
  evaluations: number
}

export interface TraceRows {
  columns: string[]
  iterations: Float64Array
  rows: Float64Array
}

/** What a planner printed. */
export interface Line {
  /** −1: while its code was read. */
  iteration: number
  text: string
}

/** How far a run has come at its furthest. */
export interface Furthest {
  iteration: number
  evaluations: number
  /** The iterations that a timeline shows. */
  extent: number
  /** The most evaluations of one step. */
  most: number
  /** There is nothing beyond. */
  ended: boolean
  /** Its last steps evaluated nothing: they are beyond its last evaluation. */
  tail: boolean
}

/** What is drawn of a run at an iteration. */
export interface Picture {
  generation: number
  /** Who drew the frame: the span table counts this planner's layers. */
  planner: string
  iteration: number
  frame: Frame
}

/** The state of a run, with its picture. On its way there are more pictures than reports. */
export interface Report extends Picture {
  is: 'report'
  /** The newest change that it follows. */
  version: number
  /** In the first report of a run. */
  run: Run | null
  evaluations: number
  furthest: Furthest
  status: Status
  playing: boolean
  readings: Record<string, number>
  /** Where there are too many pieces, one of so many is drawn. */
  thinning: number
  /** The smallest and the largest value of each field that is shown. */
  ranges: Record<string, [number, number]>
  trace: TraceRows
  /** What happened in simulated time since the furthest state that was reported. */
  events: RunEvent[]
  /** These are the events from the beginning to here, and the parts: said in another language. */
  repeats: boolean
  /** If it has changed. */
  span: Span | null
  inspection: Inspection | null
  /** What it would have done. */
  supposed: Inspection | null
  /** The members' numbers, row by row; null: not asked for, or not again yet. */
  members: Float64Array | null
  /** It is where it was wanted, and stays there. */
  arrived: boolean
  /** It costs more than a picture: while the run plays it comes a few times a second. */
  outcome: Outcome | null
  /** With the outcome, if links are wanted and the part of the core that makes them is there. */
  link: string | null
  /** Only where the run stays. */
  hash: string | null
  /** The best so far, by evaluations; if it has grown, and only by the clock of evaluations. */
  curve: TrialCurve | null
}

/**
 * A step takes long. How far the runs of other planners are that it needs; `done` null: it needs none, nothing is counted; `total` 0:
 * no step takes long any more.
 */
export interface Progress {
  is: 'progress'
  generation: number
  /** The iteration that the step leads to. */
  step: number
  done: number | null
  total: number
}

/** A question to the host: the name of a function of `Questions`, and its arguments. */
export interface Question {
  name: string
  given: unknown[]
}

/** Messages without a receipt have the number 0. */
export type ToHost = { number: number } & (
  | { is: 'open'; core: WebAssembly.Module | undefined; files: Files | undefined }
  | { is: 'want'; version: number; change: Partial<Desired> }
  | { is: 'ask'; question: Question }
  /** What runs of other planners found; null: they cannot be carried out elsewhere. */
  | { is: 'results'; id: number; results: Finding[] | null }
  | { is: 'buffer'; buffer: ArrayBuffer }
  /** Only its receipt matters. */
  | { is: 'ping' }
)

export type FromHost =
  | { is: 'open' }
  /** It has received the message with this number, and all before it. */
  | { is: 'seen'; number: number }
  /** The setup of the start that this change wanted is accepted. */
  | { is: 'accepted'; version: number }
  | { is: 'refused'; version: number; refusal: Refusal }
  | Report
  | ({ is: 'picture' } & Picture)
  | Progress
  /** Runs of other planners that the next step needs; none: those that were asked for are not needed any more. */
  | { is: 'subtasks'; id: number; generation: number; step: number; planner: string; scene: Scene; tasks: Job[] }
  /** To the question with this number. */
  | { is: 'answer'; number: number; value?: unknown; error?: string }
  /** The core broke down: nothing more comes from this host. */
  | { is: 'broken'; message: string }
