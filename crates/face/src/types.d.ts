/** Something that happened in simulated time, or was decided. */
export interface RunEvent {
  /** The iteration after which it is known. */
  iteration: number;
  /** In seconds of simulated time. */
  time: number;
  /** Where the robot was. */
  place: Point;
  /** One of the planner's `events`. */
  kind: string;
  /** The number of the moving obstacle that it is about. */
  obstacle?: number;
  /** Why, in a sentence. */
  reason: string;
}

/** A part of a run that has its own kind of step. */
export interface Stage {
  name: string;
  title: string;
  /** Its last iteration, as soon as it is known. */
  end?: number;
}

/** Sizes that a planner's paper recommends for a setup. */
export interface Suggestion {
  population: number;
  iterations: number;
  /** E.g. `[LTQPSO] (10), uniform start`. */
  source: string;
}

/** A number that a drive tells for each moment. */
export interface DriveColumn {
  name: string;
  title: string;
  symbol: string;
  /** `s`, `m`, `rad/s`, …; empty for a bare number. Lengths are in the scene's unit. */
  unit: string;
}

/** How a drive along a path went. */
export interface DriveOutcome {
  /** Seconds from start to stop. */
  time: number;
  /** How far the robot's centre went. */
  distance: number;
  /** It stopped at the goal. */
  arrived: boolean;
  /** Its outline overlapped an obstacle somewhere on its way; to touch with distance 0 is allowed. */
  touched: boolean;
  /** Where its centre was when it first did. */
  touched_at?: Point;
  /** The smallest distance of its outline from an obstacle; negative: overlap. `null` without obstacles. */
  clearance: number | null;
  /** The largest distance of its centre from the path. */
  max_error: number;
  /** The root of the mean squared distance. */
  rms_error: number;
  /** What the wheel encoders counted in all: left, right. */
  counts: [number, number];
}

/** The robot driving along a path, one row for each control period. */
export interface Drive {
  /** Names of the row's numbers, as in `catalogue().drive.columns`; `time`, `x`, `y` and `heading` (radians) among them. */
  columns: string[];
  rows: Float64Array;
  outcome: DriveOutcome;
  /** The robot's outline: along and across its heading. */
  outline: { length: number; width: number };
  parameters: Record<string, ParameterValue>;
}

/** What there is to know about driving along a path. */
export interface DriveEntry {
  /** E.g. `[LTQPSO] §5`. */
  source: string;
  summary: string;
  parameters: Parameter[];
  columns: DriveColumn[];
  formulas: Formula[];
}

/** How an arm follows the path. */
export interface MotionOutcome {
  /** Seconds from start to end. */
  time: number;
  /** How far the tip goes. */
  length: number;
  /** Every point of the path has a posture: the tip comes to the goal. */
  arrived: boolean;
  /** No link touches a cuboid or the column, all along. */
  free: boolean;
  /** When the first touch is. */
  touched_at?: number;
  /** The smallest distance of a link from a cuboid; negative: overlap. `null` without cuboids. */
  clearance: number | null;
  /** The largest turn of a joint from one row to the next, in degrees. */
  largest_step: number;
  /** The largest distance of the tip from the path. */
  max_error: number;
  /** Points without a posture, replaced by their mirror image and by random joints. */
  mirrored: number;
  drawn: number;
  /** Where it ends, and why, if it does not arrive; where the tip first leaves the path by more than a centimetre, if it does. */
  trouble?: string;
}

/** An arm following a path, one row for each moment; between rows the joints turn evenly. */
export interface Motion {
  /** Names of the row's numbers, as in `catalogue().motion.columns`: `time`, `along`, `x`, `y`, `z`, `q1` … `q6` (degrees), `clearance`. */
  columns: string[];
  rows: Float64Array;
  /** Base, shoulder, elbow, wrist and tip, x, y, z each: 15 numbers a row. */
  skeletons: Float64Array;
  outcome: MotionOutcome;
  parameters: Record<string, ParameterValue>;
}

/** Where an arm's links are in a posture. */
export interface ArmPose {
  /** Base, shoulder, elbow, wrist and tip. */
  skeleton: Point3[];
  /** Where the tool points: a unit vector in the world. */
  direction: Point3;
  /** No link touches a cuboid or the column. */
  free: boolean;
}

/** A posture that brings the tip to a point. */
export interface ArmSolution {
  /** Degrees. */
  joints: number[];
  /** Base, shoulder, elbow, wrist and tip. */
  skeleton: Point3[];
  /** No link touches a cuboid or the column. */
  free: boolean;
}

/** The postures that bring the tip to a point with the tool pointing one way: up to 8 within the limits, nearest to the given one first. */
export interface ArmSolutions {
  /** Where the tool points: a unit vector in the world. Null if none was given and none of those tried has a solution. */
  direction: Point3 | null;
  solutions: ArmSolution[];
  /** Why there are none. Without a direction `orientation` means: none of those tried, but others could. */
  unreachable?: 'position' | 'orientation' | 'limits';
}

/** Where an arm's tip can come, on a lattice over the workspace: x, y, z, and the share of 42 directions spread over the sphere in
 * which the tool can point there (a posture within the limits that touches nothing), from 0 to 1, for each point. */
export interface Reachability {
  points: Float32Array;
  /** The distance of neighbours. */
  step: number;
}

export interface Setup {
  planner: string;
  /** A scene, or the name of one that ships. */
  scene: Scene | string;
  /** Only what differs from the defaults is needed. */
  params?: Record<string, ParameterValue>;
  /** 0 … 2^53 − 1. Default 1. */
  seed?: number;
}

/** A link, taken apart. */
export interface LinkSetup {
  planner: string;
  scene: Scene;
  params: Record<string, ParameterValue>;
  seed: number;
  iteration: number;
  /** The state's hash that the link promises. */
  hash?: string;
}

/** `running`, or why it stopped: `solved`, `exhausted` (the iteration limit or an early stop), `infeasible`. */
export type Status = 'running' | 'solved' | 'exhausted' | 'infeasible';

/** Views into the wasm memory: valid until the next call of anything in this module. Copy what you keep. */
export interface FrameViews {
  /** x, y, z, weight for each vertex. */
  vertices: Float32Array;
  /** layer, shape, first vertex, count for each span; the layer as its place among the planner's `layers` in the catalogue. */
  spans: Uint32Array;
  /** How many of the planner's pieces were left out to keep to the budget: every `thinning`-th is drawn. */
  thinning: number;
}

/** An `ImageData`, where the program's libraries know what that is. */
export type Pixels = typeof globalThis extends { ImageData: { prototype: infer T } }
  ? T
  : { readonly width: number; readonly height: number; readonly data: Uint8ClampedArray };

/** The 2D context of an `OffscreenCanvas`. */
export interface CanvasContext {
  readonly canvas: { readonly width: number; readonly height: number };
}

/** A field of a frame, coloured: a pixel for each value, the row of the smallest y first. */
export interface LayerImage {
  image: Pixels;
  /** The part of the plane that it covers. */
  min: Point;
  max: Point;
  /** The smallest and the largest value. */
  range: [number, number];
}

/** A run of another planner on the same scene that a planner of planners needs. */
export interface Job {
  planner: string;
  params: Record<string, ParameterValue>;
  seed: number;
  /** Where it starts and where it leads, if not where the scene says. */
  ends?: [Point, Point];
}

/** What such a run found. */
export interface Finding {
  cost: number | null;
  /** The iteration in which the best was found. */
  converged: number;
  path: Point[];
}

export interface Item {
  role: string;
  index: number;
}

/** Why something did what it did in the step that led to this iteration. */
export interface Inspection {
  item: Item;
  title: string;
  /** What happened: `start`, `move`, `hen`, `chick`, … */
  event: string;
  /** The same in a sentence. */
  summary: string;
  /** Numbers by name, as the formulas' placeholders use them. */
  values: { name: string; symbol: string; title: string; value: number }[];
  /** Which of the planner's formulas (by name) say it. */
  formulas: string[];
  /** One row a dimension, waypoint, …; columns are symbols (TeX). */
  table: { columns: { name: string; symbol: string; title: string }[]; labels: string[]; rows: number[][] };
  /** Arrows and marks to draw over the stage. */
  /** In the plane z is 0. */
  layers: { role: string; shape: string; vertices: Point3[] }[];
}

export interface Outcome {
  planner: string;
  scene: string;
  seed: number;
  iterations: number;
  evaluations: number;
  status: Status;
  /** What was minimised. `null` before anything was found. */
  cost: number | null;
  /** The path's length, in the scene's unit. */
  length: number | null;
  /** True only if the result was checked and breaks nothing, whatever the penalty was. */
  feasible: boolean;
  /** Smallest distance to an obstacle; negative: how deep the path cuts. */
  clearance: number | null;
  /** The exact optimum by the rule that the planner keeps to. */
  exact: number | null;
  /** Which optimum that is: over the cells of a grid, at any angle, by the scene's distances, or as its file says; `refuted`: this result is
   * shorter than what the file gives, so there is none. */
  exact_by: 'any-angle' | 'cells' | 'matrix' | 'stored' | 'refuted';
  /** (length − exact) / exact. */
  gap: number | null;
  /** At how many corners the path turns. Paths only. */
  turns?: number;
  /** How much the path turns in all, in radians. Paths only. */
  turning?: number;
  /** How the scene's robot drives along the path, with the usual parameters. Scenes with a robot that has an outline only. */
  drive?: DriveOutcome;
  path?: Point[];
  /** Arms only: the corners of the tip's path. */
  tip_path?: Point3[];
  /** Arms only: the postures that were planned, in degrees, where the planner plans postures. */
  joints?: number[][];
  /** Arms only: how the arm follows the path, with the usual parameters. */
  motion?: MotionOutcome;
  /** Tours only: the stops' numbers, from 0, in the order in which it calls at them. */
  order?: number[];
  position?: number[];
  readings: Record<string, number>;
  /** What keeps the planner from a result, if something does. */
  trouble?: string;
  /** What happened in simulated time, and what was decided and why. */
  events?: RunEvent[];
  /** What a planner of planners recommends: a planner and its parameters. */
  tuned?: { planner: string; params: Record<string, ParameterValue> };
  /** No random number has a part in the run: other seeds give the same result. */
  deterministic: boolean;
  /** 16 hexadecimal digits over setup, iteration, best and state. */
  hash: string;
  parameters: Record<string, ParameterValue>;
}

/** Readings of past iterations: `rows` holds `columns.length` numbers for each kept iteration. */
export interface Trace {
  columns: string[];
  /** The iterations that the rows belong to. */
  iterations: Float64Array;
  rows: Float64Array;
}

/** A file as bytes. */
export interface NamedFile {
  name: string;
  bytes: Uint8Array;
}

/**
 * What a scene can be written as: MovingAI's `.map` and `.scen`, map_server's `.yaml` and `.pgm` (grids only), TSPLIB's `.tsp` with an
 * `.opt.tour` where the shortest tour is known, a CSV of points (stops of a tour only), or its JSON.
 */
export type Format = 'movingai' | 'ros' | 'tsplib' | 'csv' | 'json';

/** A problem of a MovingAI `.scen` file. */
export interface Problem {
  start: Point;
  goal: Point;
  /** The length that the file gives, in cells. */
  length: number;
}

/** What came of files of another format. */
export interface Imported {
  /** A grid, a tour's stops (of a `.tsp` or `.csv`), or what a scene's own JSON is. */
  scene: Scene;
  /** What was read in some way that should be known: unknown cells taken as blocked, ends chosen, how long a `.tour` is, … */
  notes: string[];
  /** The problems of a `.scen` file, if one was among the files. The scene has the last one's ends unless another is asked for. */
  problems: Problem[];
}

/** What a random scene is made of. */
export interface Generator {
  name: string;
  title: string;
  help: string;
  parameters: Parameter[];
}

/** An `Error` that says which field is wrong. */
export interface ForageError extends Error {
  /** E.g. `population`, `discs[2].radius`. */
  field: string;
  value: string;
  allowed: string;
}
