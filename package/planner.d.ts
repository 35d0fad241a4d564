import type { Catalogue, Scene, UncheckedSetup } from './forage.js'

/** A point in the plane, in the scene's unit. */
export type Point = readonly [number, number]

/** What a planner's functions are given besides its state. What they compute by it is the same bits everywhere. */
export interface Tools {
  /** The scene, as in its file; it cannot be changed. */
  readonly scene: Scene
  /** The values of the parameters, by name. */
  readonly params: Readonly<Record<string, number | string | boolean>>
  readonly seed: number
  /** Where solutions are looked for: the lowest and the highest of each variable, or of x and y. Not on tours. */
  readonly box: { readonly low: readonly number[]; readonly high: readonly number[] }
  /** `Math` with the bits of the core: `Math.sin` and others may differ between browsers. */
  readonly math: Pick<
    Math,
    | 'sin'
    | 'cos'
    | 'tan'
    | 'exp'
    | 'log'
    | 'log10'
    | 'pow'
    | 'atan2'
    | 'acos'
    | 'asin'
    | 'sqrt'
    | 'abs'
    | 'floor'
    | 'ceil'
    | 'round'
    | 'trunc'
    | 'sign'
    | 'min'
    | 'max'
    | 'hypot'
    | 'imul'
    | 'clz32'
    | 'fround'
    | 'PI'
    | 'E'
    | 'SQRT2'
    | 'SQRT1_2'
    | 'LN2'
    | 'LN10'
    | 'LOG2E'
    | 'LOG10E'
  >
  /** A uniform number in [0, 1) from the run's own stream. While `start` or `advance` runs, like all that follow. */
  random(): number
  /** A number from the standard normal distribution. */
  normal(): number
  /**
   * The cost of a candidate; counts as an evaluation. On functions: the value at a position. Among discs and on grids: the length of a
   * path from start to goal, infinite where it is not free. On tours: the length of the tour that visits the stops in this order.
   */
  evaluate(candidate: ArrayLike<number> | readonly Point[]): number
  /** Whether the robot can go straight from one point to another. Among discs and on grids. */
  isFree(from: Point, to: Point): boolean
  /** The distance of two stops, by number. On tours. */
  distance(from: number, to: number): number
  /** The run ends after this step: there is nothing more to do. */
  finish(): void
}

/** A parameter: a number from `min` to `max` (whole if `integer`), a flag, or one of `options`. `default` says which. */
export interface ParameterInJavaScript {
  /** Small letters, digits, - and _, a letter first. */
  name: string
  title?: string
  /** In TeX. */
  symbol?: string
  help?: string
  default: number | boolean | string
  min?: number
  max?: number
  integer?: boolean
  options?: readonly string[]
}

/** A number that is reported after each iteration. */
export interface ReadingInJavaScript<State> {
  name: string
  title?: string
  /** In TeX. */
  symbol?: string
  help?: string
  value(state: State): number
}

/** Something that is drawn. A layer of a name that the package's planners use (`particles`, `best`, `tree`, …) looks as theirs. */
export interface LayerInJavaScript {
  name: string
  title?: string
  help?: string
  /** What is drawn can be chosen, and `explain` explains it. */
  pickable?: boolean
}

/** Draws layers. A point's weight, if there is one, is drawn as far as the layer's look has a use for it. */
export interface Pen {
  points(layer: string, points: readonly ArrayLike<number>[], weights?: ArrayLike<number>): void
  line(layer: string, points: readonly ArrayLike<number>[], weights?: ArrayLike<number>): void
  /** Lines that do not hang together: points 0 and 1, points 2 and 3, and so on. */
  segments(layer: string, points: readonly ArrayLike<number>[], weights?: ArrayLike<number>): void
}

/** A solution and its cost: a position, a path from start to goal, or an order of stops. */
export interface SolutionInJavaScript {
  cost: number
  position?: ArrayLike<number>
  path?: readonly Point[]
  order?: ArrayLike<number>
}

/**
 * A planner in JavaScript.
 *
 * Its state is plain data: numbers, texts, true, false, null, lists, typed arrays and plain objects. All that the planner knows is in
 * it, and it is the same for the same scene, parameters and seed: so runs can be stepped back, hashed and linked. `start` and `advance`
 * take random numbers, costs and the sine from their tools, nothing else; the other functions change nothing. After how many
 * iterations a run ends is the parameter `iterations`, which every planner has.
 */
export interface PlannerInJavaScript<State extends object = Record<string, unknown>> {
  /** Small letters, digits, - and _, a letter first. No name of the package's own planners. */
  name: string
  title?: string
  summary?: string
  /** The kinds of scenes that it runs on; `tour` only alone. */
  kinds: readonly ('function' | 'discs' | 'grid' | 'tour')[]
  parameters?: readonly ParameterInJavaScript[]
  /** Numbers of an iteration. Without any, functions and tours have the best cost. */
  readings?: readonly ReadingInJavaScript<State>[]
  layers?: readonly LayerInJavaScript[]
  /** What it computes, in TeX. */
  formulas?: readonly { name: string; title?: string; tex: string; source?: string }[]
  /** Makes the state before the first step. */
  start(tools: Tools): State
  /** Takes a step. It may change the state in place; what it returns, if it returns something, is the state from then on. */
  advance(state: State, tools: Tools): State | undefined
  /** The best solution so far; nothing while there is none. Its cost never rises. */
  best(state: State): SolutionInJavaScript | null | undefined
  /** Draws what there is to see. Without it the best is drawn. */
  draw?(state: State, pen: Pen, tools: Tools): void
  /** Explains an item of a layer, by its number among all points of that layer. */
  explain?(
    state: State,
    item: { layer: string; index: number },
    tools: Tools,
  ): string | { title?: string; summary: string; values?: Record<string, number> } | null | undefined
}

/** What the catalogue lists of a planner. */
export type Described = Catalogue['planners'][number]

/** The setup of a run of such a planner: `new Session({ planner: name, scene: 'sphere' } as Setup)`. */
export type SetupInJavaScript = UncheckedSetup
