// Written by scripts/docs.mjs from the Rust types.

/** A six-axis arm with a spherical wrist, as data. */
export type Arm = {
  /** The joints, from the base to the wrist. */
  joints: [Joint, Joint, Joint, Joint, Joint, Joint]
  /** The tool at its end. */
  tool: Tool
  /** Its base. */
  base: Base
}

/** Where an arm's links are in a posture. */
export type ArmPose = {
  /** Base, shoulder, elbow, wrist and tip, in metres. */
  skeleton: [
    [number, number, number],
    [number, number, number],
    [number, number, number],
    [number, number, number],
    [number, number, number],
  ]
  /** Where the tool points: a unit vector in the world. */
  direction: [number, number, number]
  /** No link touches a cuboid or the column. */
  free: boolean
}

export type ArmScene = {
  format: 'forage-scene'
  version: 1
  kind: 'arm'
  /** Short identifier, used in links and on the command line. */
  name: string
  /** A line for people. */
  title: string
  /** A remark, e.g. which parts are reconstructed. */
  note?: string
  /** The source of its data. */
  source?: string
  /** The unit of its lengths. */
  units?: string
  /** The optimum stated in the file; results are measured against the computed one. */
  exact?: { length?: number; order?: number[]; tip_length?: number; straight?: number; [also: string]: unknown }
  /** Published values for it, as in the file. */
  published?: Record<string, unknown>
  /** The region in which the tip may be, in metres. */
  workspace: Cuboid
  /** The start of the tip's path. */
  start: [number, number, number]
  /** The goal of the tip's path. */
  goal: [number, number, number]
  /** The obstacles. */
  cuboids: Array<Cuboid>
  /** The arm. */
  arm: Arm
}

/** A posture that brings the tip to a point. */
export type ArmSolution = {
  /** In degrees. */
  joints: [number, number, number, number, number, number]
  /** Base, shoulder, elbow, wrist and tip, in metres. */
  skeleton: [
    [number, number, number],
    [number, number, number],
    [number, number, number],
    [number, number, number],
    [number, number, number],
  ]
  /** No link touches a cuboid or the column. */
  free: boolean
}

/** The postures that bring the tip to a point with the tool pointing one way. */
export type ArmSolutions = {
  /** Where the tool points: a unit vector in the world. `null` if none was given and none of those tried has a solution. */
  direction: [number, number, number] | null
  /** Up to 8 within the limits, nearest to the given one first. */
  solutions: Array<ArmSolution>
  /** Why there are none. Without a direction `orientation` means: none of those tried, but others could. */
  unreachable?: Unreachable
}

/** An axis of the last joint's frame. */
export type Axis = 'x' | 'y' | 'z'

/** The quartiles of a group of runs at each place; `null` where one falls on runs without a result, and after the last end. */
export type Band = {
  /** The lower quartile. */
  lower: Array<number | null>
  /** The median. */
  median: Array<number | null>
  /** The upper quartile. */
  upper: Array<number | null>
}

/** Quartiles of the best values of several groups of runs, over evaluations: step functions. */
export type Bands = {
  /**
   * The places of the quartiles: wherever a value changed, or, if that is at more than 400, about 400 of them, denser at the beginning,
   * with the first and each group's end.
   */
  evaluations: Array<number>
  /** The quartiles of each group. */
  groups: Array<Band>
}

/** The position of the arm in the world. */
export type Base = {
  /** The origin of the first joint in the world, in metres. */
  position: [number, number, number]
  /** The rotation about z, in degrees. */
  yaw?: number
  /** The radius of the column from the workspace's floor up to the base, in metres; 0: no column. */
  column_radius?: number
}

/** An axis-parallel box. */
export type Bounds = {
  /** Lower left corner. */
  min: [number, number]
  /** Upper right corner. */
  max: [number, number]
}

/** A case: a planner on a shipped scene, with parameters and a seed with which there is something to see. */
export type Case = {
  /** Its name among the planner's cases. */
  name: string
  /** Its title: a few plain words. */
  title: string
  /** What there is to see, in one or two sentences. */
  help: string
  /** A shipped scene. */
  scene: SceneName
  /** The seed. */
  seed: number
  /** The values that differ from the defaults. */
  params: Record<string, ParameterValue>
}

/** All that ships: planners, scenes, generators. */
export type Catalogue = {
  /** The crate's version. */
  version: string
  planners: Array<Planner>
  /** The scenes that ship. */
  scenes: Scene[]
  /** What makes random scenes. */
  generators: Array<Generator>
  /** The keys of all layers. A frame's table of spans counts its planner's `layers`, not these. */
  roles: Array<LayerName>
  /** The layers of a scene itself, whatever the planner draws. */
  layers: Array<Layer>
  /** The shapes in a frame's table of spans, by number. */
  shapes: [Shape, Shape, Shape, Shape, Shape]
  /** The colours of a function's heights, from the lowest value to the highest. */
  heights: [Color, Color, Color, Color, Color]
  /** Every TeX string outside a formula, so that a page can typeset them when it is built. */
  symbols: Array<string>
  /** How a robot drives along what a planner found. */
  drive: DriveEntry
  /** How an arm follows what a planner found. */
  motion: DriveEntry
}

/** How many times larger a planner's gap is on test functions that were changed, with equal evaluations. */
export type CentreBias = {
  /** On functions whose minimum is shifted away from the centre of the search box. */
  shifted: Ratio
  /** On functions whose axes are rotated. */
  rotated: Ratio
  /** That of random search on the shifted functions, for comparison. */
  random_search: Ratio
}

/** One of a choice's options. */
export type Choice = {
  /** The value. */
  value: string
  /** The title. */
  title: string
  /** What it does. */
  help: string
}

/** A colour in the light and in the dark theme. */
export type Color = {
  /** On a light ground. */
  light: string
  /** On a dark ground. */
  dark: string
}

/** The comparison of several groups. */
export type Comparison = {
  /** A summary of each group. */
  groups: Array<GroupSummary>
  /** The comparison of each pair. */
  pairs: Array<Pair>
  /**
   * Friedman's test over scenes and seeds, of the groups that are not deterministic; `null` if they are not equally long, or
   * fewer than two.
   */
  friedman: Friedman | null
}

/** An axis-parallel box, closed: what touches a face meets it. */
export type Cuboid = {
  /** The smallest coordinates. */
  min: [number, number, number]
  /** The largest coordinates. */
  max: [number, number, number]
}

/** A disc; its rim belongs to the free space, so a path may touch it. */
export type Disc = {
  /** Its centre. */
  center: [number, number]
  /** Its radius, positive. */
  radius: number
}

export type DiscsScene = {
  format: 'forage-scene'
  version: 1
  kind: 'discs'
  /** Short identifier, used in links and on the command line. */
  name: string
  /** A line for people. */
  title: string
  /** A remark, e.g. which parts are reconstructed. */
  note?: string
  /** The source of its data. */
  source?: string
  /** The unit of its lengths. */
  units?: string
  /** The optimum stated in the file; results are measured against the computed one. */
  exact?: { length?: number; order?: number[]; tip_length?: number; straight?: number; [also: string]: unknown }
  /** Published values for it, as in the file. */
  published?: Record<string, unknown>
  /** The region in which waypoints are searched. A path may leave it between them. */
  bounds: Bounds
  /** The start of the path. */
  start: [number, number]
  /** The goal of the path. */
  goal: [number, number]
  /** The obstacles. */
  discs: Array<Disc>
}

/** A number that is recorded for each moment of a motion. */
export type DriveColumn = {
  /** An identifier. */
  name: string
  /** The title, a few words. */
  title: string
  /** The symbol, in TeX. */
  symbol: string
  /** The unit: `s`, `m`, `rad/s`, …; empty for a bare number. `m` means the scene's unit. */
  unit: string
}

/** How a robot, or an arm, follows a path. */
export type DriveEntry = {
  /** E.g. `[LTQPSO] §5`. */
  source: string
  summary: string
  parameters: Array<Parameter>
  /** The numbers of each row. */
  columns: Array<DriveColumn>
  formulas: Array<Formula>
}

/** How a drive along a path went. */
export type DriveOutcome = {
  /** Seconds from start to stop. */
  time: number
  /** How far the robot's centre went. */
  distance: number
  /** It stopped at the goal, within a hundredth of the robot's length. */
  arrived: boolean
  /**
   * Its outline overlapped a blocked cell somewhere on the way, not only where a period ended. To touch with
   * distance 0 is allowed.
   */
  touched: boolean
  /** Where its centre was when it first did. */
  touched_at?: [number, number]
  /**
   * The smallest distance of its outline from a blocked cell on the way, to within a share of the robot's length
   * and a hundredth of itself; negative: overlap. `null` without obstacles.
   */
  clearance: number | null
  /** The largest distance of its centre from the path where a period ended. */
  max_error: number
  /** The root of the mean of their squares. */
  rms_error: number
  /** What the wheel encoders counted in all: left, right. */
  counts: [number, number]
}

/** A kind of event in simulated time. */
export type EventKind = {
  /** An identifier. */
  name: string
  /** The title, a few words. */
  title: string
  /** What it means. */
  help: string
  /** Its tone. */
  tone: 'plain' | 'warning' | 'decision' | 'good' | 'bad'
}

/** An exact optimum: a shortest path or tour. */
export type Exact = {
  /** Its length, in the scene's unit. */
  length: number
  /**
   * The corners of the path. Arcs become corners just outside their discs, so that this line is collision-free and hardly
   * longer.
   */
  path: Array<[number, number]>
  /** The path of an arm's tip in space, in metres; `path` is empty then. Otherwise empty. */
  tip_path?: Array<[number, number, number]>
  /** The visiting order of a tour's stops; otherwise empty. */
  order?: Array<number>
  /** Whether it is stated in the scene file and was not computed. */
  stored: boolean
}

/** The result of a `Subtask`. */
export type Finding = {
  /** The best cost; `null` if nothing feasible was found. */
  cost: number | null
  /** The iteration in which the best was found. */
  converged: number
  /** The best path; empty if nothing feasible was found. */
  path: Array<[number, number]>
}

/** An equation that a planner computes. */
export type Formula = {
  /** An identifier within the planner. Equations of which one is computed, depending on `when`, share it. */
  name: string
  /** The source, e.g. `[WCPSO] (3)`. */
  source: string
  /** The title, a few words. */
  title: string
  /** The equation in TeX, as in the paper. `\class{inertia}{…}` is the term that explanations mark by the layer of that name. */
  tex: string
  /** The equation in TeX, with `@name@` in place of each current number. */
  live?: string
  /** Where those numbers come from. */
  scope: 'iteration' | 'item'
  /** The parameter value with which the equation is computed; `null`: with any. */
  when?: When
}

export type FormulaScene = {
  format: 'forage-scene'
  version: 1
  kind: 'function'
  /** Short identifier, used in links and on the command line. */
  name: string
  /** A line for people. */
  title: string
  /** A remark, e.g. which parts are reconstructed. */
  note?: string
  /** The source of its data. */
  source?: string
  /** The unit of its lengths. */
  units?: string
  /** The optimum stated in the file; results are measured against the computed one. */
  exact?: { length?: number; order?: number[]; tip_length?: number; straight?: number; [also: string]: unknown }
  /** Published values for it, as in the file. */
  published?: Record<string, unknown>
  /** The formula, at most 4096 bytes: `sum(x[i]^2)`. */
  expression: string
  /** The number of variables. */
  dimension: number
  /** Where the minimum is searched. */
  bounds: SearchBounds
  /** The minimum, if it is known, with its position or without. */
  optimum?: number | { value: number; position?: number[] }
}

/** Mean ranks of groups over common scenes and seeds, and Friedman's test of whether they differ. */
export type Friedman = {
  /** The number of scenes and seeds. */
  blocks: number
  /** The mean rank of each group, 1 is the best; ties share their mean rank. `null` of a deterministic one. */
  ranks: Array<number | null>
  /** Friedman's statistic, corrected for ties; `null` for two groups, or if all are tied everywhere. */
  statistic: number | null
  /** Its p-value by the chi-squared distribution. */
  p: number | null
  /** How far apart two mean ranks must be to differ at the 5 % level, by Nemenyi's test. */
  critical_difference: number | null
}

/** A scene with a function to minimise. */
export type FunctionScene = NamedFunctionScene | SuiteFunctionScene | FormulaScene

/** What makes random scenes. */
export type Generator = { name: GeneratorName; title: string; help: string; parameters: Array<Parameter> }

/** The form of a layer's points or tubes. */
export type Glyph = 'ring' | 'diamond' | 'number' | 'arrow' | 'disc' | 'band' | 'reach' | 'robot' | 'event'

export type GridScene = {
  format: 'forage-scene'
  version: 1
  kind: 'grid'
  /** Short identifier, used in links and on the command line. */
  name: string
  /** A line for people. */
  title: string
  /** A remark, e.g. which parts are reconstructed. */
  note?: string
  /** The source of its data. */
  source?: string
  /** The unit of its lengths. */
  units?: string
  /** The optimum stated in the file; results are measured against the computed one. */
  exact?: { length?: number; order?: number[]; tip_length?: number; straight?: number; [also: string]: unknown }
  /** Published values for it, as in the file. */
  published?: Record<string, unknown>
  /** The side of a cell, in the scene's unit. */
  cell: number
  /** Blocked cells, row by row. Row `k` covers `k · cell ≤ y ≤ (k + 1) · cell`, whichever way y grows. */
  rows: Array<string>
  /** The direction in which y grows. */
  y_axis?: YAxis
  /** The start of a path. */
  start?: [number, number]
  /** The goal of a path. */
  goal?: [number, number]
  /** The stops of a tour. */
  stops?: Array<[number, number]>
  /** Whether a diagonal move may cut a blocked cell's corner. */
  corner_cutting?: boolean
  /** The robot. */
  robot?: Robot
  /** The moving obstacles. */
  moving?: Array<Moving>
}

/** The runs of a planner, or another group to compare. */
export type Group = {
  /** Its name. */
  name: string
  /**
   * The result of each run, smaller is better; `null` without a feasible result. In all groups the same index means the
   * same scene and seed.
   */
  values: Array<number | null>
  /** Every seed gives the same run: then tests, which ask whether chance alone explains a difference, say nothing of it. */
  deterministic?: boolean
}

/** The summary of a group. */
export type GroupSummary = {
  /** Its name. */
  name: string
  /** The number of runs. */
  runs: number
  /** The number of runs with a feasible result. */
  feasible: number
  /** The feasibility rate, from 0 to 1. */
  rate: number
  /** The 95 % confidence interval of `rate` (Wilson). */
  rate_interval: [number, number]
  /** The summary of the feasible results; `null` if there are none. */
  summary: Summary | null
}

/** A scene that was read from another format. */
export type Imported = {
  /** The scene. */
  scene: Scene
  /** Interpretations that the user should know: unknown cells taken as blocked, start and goal chosen, … */
  notes: Array<string>
  /** The problems of a `.scen` file, if one was among the files. */
  problems: Array<Problem>
}

/**
 * An explanation: what an item did in the step that led to this iteration, and why.
 *
 * Made by `Inspection::new`; what is not set is empty.
 */
export type Inspection = {
  /** The item that is explained. */
  item: Item
  /** Its name for people. */
  title: Message
  /** What happened, in a word. */
  event: string
  /** The same in a sentence. */
  summary: Message
  /** The numbers behind it. */
  values: Array<Quantity>
  /** Names of the entry's formulas that were applied. */
  formulas: Array<string>
  /** The table's columns. */
  table: InspectionTable
  /** Marks to draw over the picture. */
  layers: Array<Mark>
  /** What can be supposed otherwise in this step: `Run::suppose` answers each. */
  suppositions: Array<Label>
}

/** An inspection's table: a row for each dimension, way-point, sample, … */
export type InspectionTable = {
  columns: Array<Label>
  /** A label for each row. */
  labels: Array<Message>
  /** The numbers, row by row. */
  rows: Array<Array<number>>
}

/** A piece of a layer that can be explained, e.g. one particle. */
export type Item = {
  /** The layer that it belongs to. */
  role: LayerName
  /** Its index among all pieces of the layer, drawn or not. */
  index: number
}

/** A run of another planner on the same scene that the next step needs. */
export type Job = Configured & { seed: number /** Start and goal, if they are not the scene's. */; ends?: [Point, Point] }

/** A joint and the link before it, modified Denavit–Hartenberg: T_i = Rx(α_{i−1}) Tx(a_{i−1}) Rz(θ_i) Tz(d_i). */
export type Joint = {
  /** a_{i−1}, the length of the link before, in metres. */
  a: number
  /** α_{i−1}, the twist of the link before, in degrees: a multiple of 90. */
  alpha: number
  /** θ_i in the home configuration, in degrees. */
  home: number
  /** d_i, the offset along the joint's axis, in metres. */
  d: number
  /** The smallest θ_i, in degrees. */
  min: number
  /** The largest θ_i, in degrees. */
  max: number
  /** The largest speed, in degrees per second. The paper gives none; the default is 180. */
  speed?: number
}

/** The id of a scene kind: the name that scene files use, e.g. `grid`. Entries list the kinds that they are for. */
export type Kind = string

/** What a number in an inspection is called, or a column of its table. Made by `label!`. */
export type Label = {
  /** An identifier; formulas use it. */
  name: string
  /** The symbol, in TeX. */
  symbol: string
  title: string
}

/** A layer that a planner draws, or that its explanations mark. */
export type Layer = {
  /** The key that drawings use. */
  role: LayerName
  /** The title in a legend. */
  title: string
  /** A help text of one sentence. */
  help: string
  /** When it is shown. */
  on: boolean
  /** Whether its pieces can be inspected. */
  pickable: boolean
  /** The parameter value with which there is something to draw; `null`: with any. */
  when?: When
  /** The kinds of scene on which there is something to draw; empty: all that the planner runs on. */
  kinds?: Array<Kind>
  /** The meaning of its vertices' weight. */
  weight?: Weight
  /** Its look. */
  look: Look
}

/**
 * The name of a layer in drawings, explanations, pages, pictures and links. A planner brings new ones by listing layers under
 * them in its entry.
 */
export type LayerName = string

/** What a link says, without its scene's body in letters. */
export type LinkSetup = Configured & {
  scene: Scene
  seed: number
  iteration: number /** The state's hash that the link promises. */
  hash?: string
}

/** The look of a layer. Lengths are in pixels. */
export type Look = {
  /** Of lines and points. */
  color: Color
  /** Of what a disc, a band, a robot or a sign covers. */
  fill?: Color
  /** Of lines. */
  width: number
  /** The diameter of a point. */
  point: number
  /** Layers of a higher order are drawn later. */
  order: number
  /** The width of lines of weight 1, where those of weight 0 have `width`. */
  swell?: number
  /** The rank among the layers that show the planner's result. The highest is what is handed over. */
  result?: number
  /** Of a weight of 0, and of a weight of 1: from 0 (invisible) to 1. */
  opacity: [number, number]
  /** Lengths of dashes and gaps, in turn. Absent: solid. */
  dash?: Array<number>
  /** A form of its own, so that colour is not the only distinction. Absent: plain. */
  glyph?: Glyph
  /** How its vertices belong together, if that does not depend on the scene. */
  shape?: Shape
  /** Whether it has fine details: drawn only for the part of the plane that `lookAt` gives. */
  near?: boolean
  /** Whether a rim separates it from what lies beneath. */
  lifted?: boolean
  /** Whether the ramp is that of the values' square root. */
  root?: boolean
  /** A field's colours: of its smallest value, the middle and the largest. */
  ramp?: [Color, Color, Color]
}

/** A mark to draw over the picture. */
export type Mark = {
  /** One of the entry's layers, which says what it shows and how it looks. */
  role: LayerName
  /** How its vertices belong together. */
  shape: Shape
  /** The vertices, in the scene's unit; in the plane z is 0. */
  vertices: Array<[number, number, number]>
}

/** A number that a planner reports of each member of its population: particle, bat, ant, … */
export type Member = {
  /** An identifier. */
  name: string
  /** The symbol, in TeX. */
  symbol: string
  /** The title, a few words. */
  title: string
  /** What it says. */
  help: string
  /** The value of a full bar, which begins at 0; `null`: no bar. */
  full?: number
  /** What the values 0, 1, … stand for, if they are codes. */
  words?: Array<string>
}

/** A text for people: a key and arguments, and how it sounds in English. Made by `message!`. */
export type Message = string

/**
 * The metric of distances between points. All but the first are TSPLIB's, by its own formulas and in whole numbers, for
 * comparison with published optima.
 */
export type Metric = 'euclidean' | 'euc-2d' | 'ceil-2d' | 'att' | 'geo'

/** How the arm follows a path. */
export type MotionOutcome = {
  /** Seconds from start to end. */
  time: number
  /** How far the tip goes. */
  length: number
  /** Every point of the path has a posture: the tip comes to the goal. */
  arrived: boolean
  /** No link touches a cuboid or the column, all along: between the rows too. */
  free: boolean
  /** When the first touch is. */
  touched_at?: number
  /** The smallest distance of a link from a cuboid at the rows; negative: overlap. `null` without cuboids. */
  clearance: number | null
  /** The largest turn of a joint from one row to the next, in degrees. */
  largest_step: number
  /** The largest distance of the tip from the path. */
  max_error: number
  /** How many points had no posture and were replaced by their mirror image, [ARM-RRT] step 4. */
  mirrored: number
  /** How many were replaced by random joints between their neighbours', [ARM-RRT] step 6. */
  drawn: number
  /** Where it ends, and why, if it does not arrive; where the tip first leaves the path by more than a centimetre, if it does. */
  trouble?: string
}

/** A moving obstacle: a disc. */
export type Moving = {
  /** The position of its centre at time 0, in the scene's unit. */
  center: [number, number]
  /** Its radius, in the scene's unit. */
  radius: number
  /** Its velocity, in the scene's unit per second. */
  velocity?: [number, number]
  /** Instead of a velocity: [t, x, y] by growing t > 0, in seconds. At the last it stays. */
  waypoints?: Array<[number, number, number]>
}

export type NamedFunctionScene = {
  format: 'forage-scene'
  version: 1
  kind: 'function'
  /** Short identifier, used in links and on the command line. */
  name: string
  /** A line for people. */
  title: string
  /** A remark, e.g. which parts are reconstructed. */
  note?: string
  /** The source of its data. */
  source?: string
  /** The unit of its lengths. */
  units?: string
  /** The optimum stated in the file; results are measured against the computed one. */
  exact?: { length?: number; order?: number[]; tip_length?: number; straight?: number; [also: string]: unknown }
  /** Published values for it, as in the file. */
  published?: Record<string, unknown>
  /** The function. */
  function: TestFunction
  /** The number of variables. */
  dimension: number
  /** The position of the function's origin, a number for each variable; left out: at 0. */
  shift?: Array<number>
}

/** The result of a run so far: what was found, whether it is feasible, and what it cost. What does not apply is left out. */
export type Outcome = {
  /** The planner's name. */
  planner: PlannerName
  /** The scene's name. */
  scene: string
  /** The seed. */
  seed: number
  /** Iterations taken. */
  iterations: number
  /** Candidate solutions evaluated. */
  evaluations: number
  /** Running, or why it stopped. */
  status: Status
  /** What the planner minimised; `null` before anything was found. */
  cost: number | null
  /** The path's length, in the scene's unit. */
  length: number | null
  /** True only if the result itself was checked and breaks nothing, whatever the penalty was. */
  feasible: boolean
  /** The smallest distance to an obstacle; negative: how deep the path cuts. */
  clearance: number | null
  /** The exact optimum by the rule that the planner keeps to. */
  exact: number | null
  /** Which optimum that is: over the cells of a grid, at any angle, by the scene's distances, or as its file says. */
  exact_by: ReferenceOptimum
  /** (length − exact) / exact; `null` where the optimum is 0 or there is no length. */
  gap: number | null
  /** At how many corners the path turns. */
  turns?: number
  /** How much the path turns in all, in radians. */
  turning?: number
  /** The path's corners. */
  path?: Array<[number, number]>
  /**
   * When it was where, for a path that was driven: `[t, x, y]` at every change of its motion, in seconds. Between two of them it
   * went straight at constant speed, or stood still.
   */
  moments?: Array<[number, number, number]>
  /** The corners of the tip's path, in metres. Arms only. */
  tip_path?: Array<[number, number, number]>
  /** The postures that were planned, in degrees, where the planner plans postures. */
  joints?: Array<[number, number, number, number, number, number]>
  /** The stops' numbers in the tour's order. */
  order?: Array<number>
  /** The point in a function's box. */
  position?: Array<number>
  /** The numbers of this iteration. */
  readings: Record<string, number>
  /** What keeps the planner from a result, if something does. */
  trouble?: string
  /** Where a cost could not be computed, if that is the reason. */
  failed_at?: Array<number>
  /** What happened in simulated time, and what was decided and why. */
  events?: Array<RunEvent>
  /** What a planner of planners recommends. */
  tuned?: Recommendation
  /** No random number has a part in it: other seeds give the same result. */
  deterministic: boolean
  /** The hash of setup, iteration, best and state. It may be made empty where it is of no iteration; then it is not serialised. */
  hash: string
  /** Every parameter's value. */
  parameters: Record<string, ParameterValue>
  /** How the scene's robot drives along it. Scenes with a robot that has an outline only. */
  drive?: DriveOutcome
  /** How the arm follows it. Arms only. */
  motion?: MotionOutcome
}

/** The comparison of two groups. */
export type Pair = {
  /** The index of the first group. */
  first: number
  /** The index of the second group. */
  second: number
  /** Mann and Whitney's U of the first group; this and what follows is `null` if one of the two is deterministic. */
  u: number | null
  /** The p-value of Wilcoxon's rank-sum test, two-sided. Runs without a feasible result rank last. */
  p: number | null
  /** The p-value corrected for the number of tested pairs (Holm). */
  corrected: number | null
  /** The probability of superiority: that a run of the first group is better than one of the second; ties count half. */
  better: number
}

/** What a parameter means and what it may be: enough to make a control of it. */
export type Parameter = {
  name: string
  /** TeX. */
  symbol: string
  title: string
  help: string
  default: ParameterValue
  /** Defaults that differ on a kind of scene (the published values). */
  defaults: Partial<Record<Kind, ParameterValue>>
  /** The kinds of scene on which it means something. */
  kinds: Array<Kind>
  /** `subset`: any of the options, as text, with commas between: `alpha,beta`. */
  type: 'number' | 'integer' | 'choice' | 'flag' | 'subset'
  /** Numbers and integers only: the smallest value allowed. */
  min?: number
  /** Numbers and integers only: the largest value allowed. */
  max?: number
  /** The step of a slider; absent: continuous. */
  step?: number
  /** Choices and subsets only. */
  options?: Array<Choice>
  /** The value of another parameter without which it means nothing. */
  when?: When
  /** The smallest value that a slider offers; typing may go beyond it, down to `min`. */
  soft_min?: number
  /** The largest value that a slider offers. */
  soft_max?: number
  /** Whether a slider is logarithmic. */
  logarithmic?: boolean
}

/** A parameter's value as it is given. */
export type ParameterValue = boolean | number | string

/** A planner. */
export type Planner = {
  name: PlannerName
  title: string
  family: string
  /** E.g. `[WCPSO] (1–7)`. */
  source: string
  summary: string
  /** What one of its evaluations is, e.g. `a position`. Empty: it does not say. */
  evaluation: string
  /** The kinds of scene that it runs on. */
  kinds: Array<Kind>
  /** It calls at a scene's stops instead of going from start to goal: grids need two stops at least. */
  stops: boolean
  /** The most stops that it can do with. Absent: as many as a scene may have. */
  most_stops?: number
  parameters: Array<Parameter>
  presets: Array<Preset>
  /** Runs that show what it does. */
  cases: Array<Case>
  readings: Array<Reading>
  formulas: Array<Formula>
  /** What it does, line by line: `$…$` is TeX, `@name@` a reading or a parameter, two spaces are a level. */
  pseudocode: Array<string>
  /** The layers that it draws, in drawing order. A frame's table of spans counts them from 0. */
  layers: Array<Layer>
  /** The layers that only its explanations mark. */
  marks: Array<Layer>
  /** The numbers that it reports of each member of its population; empty: none. */
  members: Array<Member>
  /** The kinds of events that it reports. */
  events: Array<EventKind>
  /** How much it owes to the middle of the search box. Absent: not measured. */
  centre_bias?: CentreBias
}

/** A preset: a named set of parameters. */
export type Preset = {
  /** The name in commands: `paper`, `fitted`. */
  name: string
  /** The title, e.g. As in the text. */
  title: string
  /** What it is for, and what it is based on. */
  help: string
  /** A shipped scene on which to try it. */
  scene: SceneName
  /** The values that differ from the defaults. */
  params: Record<string, ParameterValue>
}

/** A problem of a MovingAI `.scen` file. */
export type Problem = {
  /** The centre of the start cell, in the scene's unit. */
  start: [number, number]
  /** The centre of the goal cell, in the scene's unit. */
  goal: [number, number]
  /** The optimal length that the file states, in cells. */
  length: number
}

/** A number in an inspection. */
export type Quantity = {
  /** The number. */
  value: number
  /** An identifier; formulas use it. */
  name: string
  /** The symbol, in TeX. */
  symbol: string
  title: string
}

/** A ratio with its 95 % interval. */
export type Ratio = {
  /** The ratio. */
  value: number
  /** Where its interval begins. */
  from: number
  /** Where it ends. */
  to: number
}

/** The empirical distribution of running times (ECDF): which share of a group's runs had reached the target after so many evaluations. */
export type Reached = {
  /** Evaluations. */
  evaluations: Array<number>
  /** Shares, 0 to 1. */
  shares: Array<number>
  /** The 95 % interval of the last share, by Wilson's score; `null` without runs. */
  interval: [number, number] | null
  /** How many evaluations a success takes; `null` if there was none, or if it is not known how many evaluations the runs took. */
  running_time: RunningTime | null
}

/** A number that a planner reports after each iteration. */
export type Reading = {
  /** Its name in readings, traces and formulas. */
  name: string
  /** The symbol, in TeX. */
  symbol: string
  /** The title, a few words. */
  title: string
  /** What it says. */
  help: string
  /** The group that it is shown in. */
  group: 'cost' | 'schedule' | 'length' | 'measure' | 'count'
}

/** Parameters that a tuning planner recommends for another planner. */
export type Recommendation = Configured

/** The optimum that a result is measured against. */
export type ReferenceOptimum = 'any-angle' | 'cells' | 'matrix' | 'stored' | 'refuted'

/** The robot of a grid; what is not given is `null`. */
export type Robot = {
  /** The length of its outline, along its heading, in the scene's unit. */
  length?: number
  /** The width of its outline, in the scene's unit. */
  width?: number
  /** Its speed, in the scene's unit per second. */
  speed?: number
  /** The turn-in-place time, in seconds. */
  turn_time?: number
  /** The sensor range, in the scene's unit. */
  sensor?: number
  /** Its radius against moving obstacles, in the scene's unit. */
  radius?: number
  /** The safety margin beyond that radius, in the scene's unit. */
  margin?: number
  /** The prediction horizon, in seconds. */
  look_ahead?: number
}

/** An event in simulated time: what happened or was decided, and why. */
export type RunEvent = {
  /** The iteration after which it is known. */
  iteration: number
  /** The simulated time, in seconds. */
  time: number
  /** The robot's position, in the scene's unit. */
  place: [number, number]
  /** The name of its kind, one of the entry's `events`. */
  kind: string
  /** The index of the moving obstacle that it is about. */
  obstacle?: number
  /** The reason, in a sentence. It follows from the rest, so that no hash depends on its words. */
  reason: Message
}

/** An [expected running time](expected_running_time) with its interval. */
export type RunningTime = {
  /** Evaluations for each success. */
  expected: number
  /**
   * The 95 % [bootstrap](bootstrap) interval; an end is `null` if too many resamples have no success for it to be finite. `null` for
   * a single run.
   */
  interval: [number | null, number | null] | null
}

/** The content of a scene file. */
export type Scene = FunctionScene | DiscsScene | GridScene | TourScene | ArmScene

/** The sides of a search box: a number for all of them, or one for each variable. */
export type SearchBounds = {
  /** The least values. */
  min: number | number[]
  /** The greatest values. */
  max: number | number[]
}

/** How a span's vertices belong together. */
export type Shape = 'points' | 'polyline' | 'segments' | 'field' | 'tube'

/** A part of a run with its own kind of step. */
export type Stage = {
  /** An identifier. */
  name: string
  /** The title, a few words. */
  title: Message
  /** Its last iteration; the next stage's first step follows. `null`: when the run ends, which is not yet known. */
  end?: number
}

/** The status of a run: whether it goes on, or why it ended. */
export type Status = 'running' | 'solved' | 'exhausted' | 'infeasible' | 'failed'

/** Sizes that a paper recommends for a setup. */
export type Suggestion = {
  /** The number of particles. */
  population: number
  /** The number of iterations. */
  iterations: number
  /** The source, e.g. `[LTQPSO] (10)`. */
  source: string
}

export type SuiteFunctionScene = {
  format: 'forage-scene'
  version: 1
  kind: 'function'
  /** Short identifier, used in links and on the command line. */
  name: string
  /** A line for people. */
  title: string
  /** A remark, e.g. which parts are reconstructed. */
  note?: string
  /** The source of its data. */
  source?: string
  /** The unit of its lengths. */
  units?: string
  /** The optimum stated in the file; results are measured against the computed one. */
  exact?: { length?: number; order?: number[]; tip_length?: number; straight?: number; [also: string]: unknown }
  /** Published values for it, as in the file. */
  published?: Record<string, unknown>
  /** Which: `bbob-1` to `bbob-24`. */
  function: `bbob-${number}`
  /** Which instance, from 1; left out: 1. */
  instance?: number
  /** The number of variables, from 2 to 40. */
  dimension: number
}

/** Mean, spread and order statistics of a sample. */
export type Summary = {
  /** The number of values. */
  count: number
  /** The mean. */
  mean: number
  /** The sample's standard deviation, with n − 1 as in Matlab's `std`; `null` for a single number. */
  std: number | null
  /** The 95 % confidence interval of the mean by Student's t, not below 0 where no value is; `null` for a single number. */
  interval: [number, number] | null
  /** The smallest value. */
  min: number
  /** The lower quartile, median-unbiased as Hyndman and Fan's type 8 (numpy's `median_unbiased`). */
  lower: number
  /** The median: the middle value, or the mean of the two in the middle. */
  median: number
  /** The upper quartile, as the lower one. */
  upper: number
  /** The largest value. */
  max: number
}

/** A test function to minimise. Each has the minimum 0. */
export type TestFunction = 'matyas' | 'egg-crate' | 'sphere' | 'rosenbrock' | 'ackley' | 'rastrigin'

/** The tool: a straight segment from the wrist to the tip. */
export type Tool = {
  /** The axis of the last frame that it lies along. */
  axis: Axis
  /** Its length, in metres. */
  length: number
}

export type TourScene = {
  format: 'forage-scene'
  version: 1
  kind: 'tour'
  /** Short identifier, used in links and on the command line. */
  name: string
  /** A line for people. */
  title: string
  /** A remark, e.g. which parts are reconstructed. */
  note?: string
  /** The source of its data. */
  source?: string
  /** The unit of its lengths. */
  units?: string
  /** The optimum stated in the file; results are measured against the computed one. */
  exact?: { length?: number; order?: number[]; tip_length?: number; straight?: number; [also: string]: unknown }
  /** Published values for it, as in the file. */
  published?: Record<string, unknown>
  /** The stops' positions; empty if only their distances are known. */
  points?: Array<[number, number]>
  /** The metric of their distances, unless `matrix` is given. */
  metric?: Metric
  /** The distances, if they are given as a matrix. */
  matrix?: Array<Array<number>>
  /** Whether a tour returns to its first stop. */
  closed?: boolean
  /** Pairs of stops that follow each other in every tour, at no cost; only of at most `MAX_MATRIX` stops. */
  fixed?: Array<[number, number]>
}

/** What a run came to. */
export type TrialRecord = {
  /** The planner's name. */
  planner: PlannerName
  /** The scene's name. */
  scene: string
  /** The seed. */
  seed: number
  /** The parameters that differ from the defaults. */
  parameters: Record<string, ParameterValue>
  /** Running, or why it stopped. */
  status: Status
  /** The iteration at which it ends at the latest. */
  limit: number
  /** Iterations taken. */
  iterations: number
  /** Candidate solutions evaluated. */
  evaluations: number
  /** What the planner minimised; `null` before anything was found. */
  cost: number | null
  /** The path's length, in the scene's unit. */
  length: number | null
  /** What runs are compared by: a feasible result's length, or where there is no path its cost. `null` if there is none. */
  value: number | null
  /** True only if the result itself was checked and breaks nothing. */
  feasible: boolean
  /** The smallest distance to an obstacle. */
  clearance: number | null
  /** The exact optimum by the rule that the planner keeps to. */
  exact: number | null
  /** Which optimum that is. */
  exact_by: ReferenceOptimum
  /** (length − exact) / exact. */
  gap: number | null
  /** Evaluations when the best was first feasible and near enough to the optimum; `null` if it never was, or there is none. */
  reached: number | null
  /** The same in iterations. */
  reached_iteration: number | null
  /** The iteration from which the population's mean stayed within 1 % of its best; `null` without such a reading, or if it never did. */
  settled: number | null
  /** At how many corners the path turns. */
  turns: number | null
  /** No random number has a part in it: other seeds give the same result. */
  deterministic: boolean
  /** The state's hash. */
  hash: string
}

/** The reason why no posture brings the tool into a pose. A later variant is closer to a solution. */
export type Unreachable = 'position' | 'orientation' | 'limits'

/** The meaning of the weight of a layer's vertices. */
export type Weight = 'rank' | 'share' | 'length' | 'pheromone' | 'place' | 'half-width' | 'time' | 'arrived'

/** A condition: another parameter and the value that it must have. */
export type When = {
  /** The other parameter. */
  parameter: string
  /** Its value as it is typed: `polar`, `true`. */
  value: string
}

/** The direction in which y grows in a scene's coordinates. The file lists the top row first in either case. */
export type YAxis = 'down' | 'up'
