// What has no Rust type of its own: names, setups, and objects of typed arrays. The rest is `types.d.ts`, from the Rust types.

/** A point [x, y] in the scene's unit. */
export type Point = [number, number]

/** A point [x, y, z] in space. */
export type Point3 = [number, number, number]

/** A planner's name. A package lists those that it has; so with the other names. */
export type PlannerName = string

/** The name of a scene that ships. */
export type SceneName = string

/** The name of a generator of random scenes. */
export type GeneratorName = string

/** The parameters of each planner. */
export type ParametersOf = Record<PlannerName, Record<string, ParameterValue>>

/** A planner with parameters. Those that are left out have their defaults. */
export type Configured = { [P in PlannerName]: { planner: P; params: ParametersOf[P] } }[PlannerName]

/** What is run. */
/**
 * A function from code, which is minimised. It must always give the same number at the same position; one that is not a number ends the
 * run, an infinite one is never the best. Such a run has no link, and cannot go to a thread.
 */
export type CodeScene = {
  kind?: 'function'
  /** The number of variables, 1 to 100. */
  dimension: number
  /** Where the minimum is searched. */
  bounds: SearchBounds
  /** The minimum, if it is known, with its position or without. */
  optimum?: number | { value: number; position?: number[] }
  name?: string
  title?: string
  note?: string
} & (
  | { /** The value at a position. */ objective: (x: Float64Array) => number }
  | {
      /** The values at many positions of `dimension` numbers, one after the other in `xs`. */ objectives: (
        xs: Float64Array,
        dimension: number,
      ) => ArrayLike<number>
    }
)
export type Setup = { scene: Scene | SceneName | CodeScene /** 0 … 2^53 − 1. Default 1. */; seed?: number } & (
  | { planner: PlannerName; params?: undefined }
  | { [P in PlannerName]: { planner: P /** Only what differs from the defaults is needed. */; params?: ParametersOf[P] } }[PlannerName]
)

/** A setup whose names are known only at run time: `new Session(setup as Setup)` refuses those that there are not. */
export interface UncheckedSetup {
  planner: string
  scene: Scene | string
  params?: Record<string, ParameterValue>
  seed?: number
}

/** The robot driving along a path, one row for each control period. */
export interface Drive {
  /** Names of the row's numbers, as in `catalogue().drive.columns`; `time`, `x`, `y` and `heading` (radians) among them. */
  columns: string[]
  rows: Float64Array
  outcome: DriveOutcome
  /** The robot's outline: along and across its heading. */
  outline: { length: number; width: number }
  parameters: Record<string, ParameterValue>
}

/** An arm following a path, one row for each moment; between rows the joints turn evenly. */
export interface Motion {
  /** Names of the row's numbers, as in `catalogue().motion.columns`: `time`, `along`, `x`, `y`, `z`, `q1` … `q6` (degrees), `clearance`. */
  columns: string[]
  rows: Float64Array
  /** Base, shoulder, elbow, wrist and tip, x, y, z each: 15 numbers a row. */
  skeletons: Float64Array
  outcome: MotionOutcome
  parameters: Record<string, ParameterValue>
}

/** Where an arm's tip can come, on a lattice over the workspace: x, y, z, and the share of 42 directions spread over the sphere in
 * which the tool can point there (a posture within the limits that touches nothing), from 0 to 1, for each point. */
export interface Reachability {
  points: Float32Array
  /** The distance of neighbours. */
  step: number
}

/**
 * 2 to 16 colours at equal distances, `#rrggbb` or `#rrggbbaa`, from the smallest value to the largest. Those of a layer and of a
 * function's heights are in the catalogue: `look.ramp`, `heights`.
 */
export type Ramp = readonly string[]

/** Views into the wasm memory: valid until the next call of anything in this module. Copy what you keep. */
export interface FrameViews {
  /** x, y, z, weight for each vertex. */
  vertices: Float32Array
  /** layer, shape, first vertex, count for each span; the layer as its place in `layers`, the shape as its place in `shapes`. */
  spans: Uint32Array
  /** The planner's layers, in drawing order: those of the catalogue. The list is the same one for each frame of a session. */
  layers: readonly LayerName[]
  /** How many of the planner's pieces were left out to keep to the budget: every `thinning`-th is drawn. */
  thinning: number
}

/** An `ImageData`, where the program's libraries know what that is. */
export type Pixels = typeof globalThis extends { ImageData: { prototype: infer T } }
  ? T
  : { readonly width: number; readonly height: number; readonly data: Uint8ClampedArray }

/** The 2D context of an `OffscreenCanvas`. */
export interface CanvasContext {
  readonly canvas: { readonly width: number; readonly height: number }
}

/** A field of a frame, coloured: a pixel for each value, the row of the smallest y first. */
export interface LayerImage {
  image: Pixels
  /** The part of the plane that it covers. */
  min: Point
  max: Point
  /** The smallest and the largest value. */
  range: [number, number]
}

/** Readings of past iterations: `rows` holds `columns.length` numbers for each kept iteration. */
export interface Trace {
  columns: string[]
  /** The iterations that the rows belong to. */
  iterations: Float64Array
  rows: Float64Array
}

/** The values of a run's feasible best, whenever it changed: three equally long columns. */
export interface TrialCurve {
  iterations: Float64Array
  evaluations: Float64Array
  values: Float64Array
}

/** A file as bytes. */
export interface NamedFile {
  name: string
  bytes: Uint8Array
}

/**
 * What a scene can be written as: MovingAI's `.map` and `.scen`, map_server's `.yaml` and `.pgm` (grids only), TSPLIB's `.tsp` with an
 * `.opt.tour` where the shortest tour is known, a CSV of points (stops of a tour only), or its JSON.
 */
export type Format = 'movingai' | 'ros' | 'tsplib' | 'csv' | 'json'

/** An `Error` that says which field is wrong. */
export interface ForageError extends Error {
  /** E.g. `population`, `discs[2].radius`. */
  field: string
  value: string
  allowed: string
}
