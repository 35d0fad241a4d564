export type ParameterValue = number | string | boolean;

/** Another parameter, and the value that it must have. */
export interface When {
  parameter: string;
  value: string;
}

/** What a parameter means and what it may be: enough to make a control of it. */
export interface Parameter {
  name: string;
  /** TeX. */
  symbol: string;
  title: string;
  help: string;
  /** `subset`: any of the options, as text, with commas between: `alpha,beta`. */
  type: 'number' | 'integer' | 'choice' | 'flag' | 'subset';
  default: ParameterValue;
  /** Defaults that differ on a kind of scene (the published values). */
  defaults: Partial<Record<Kind, ParameterValue>>;
  /** The kinds of scene on which the parameter means something. */
  kinds: Kind[];
  /** It means something only while another parameter has this value (as text: `polar`, `true`), and that one means something. */
  when?: When;
  /** Numbers and integers only: the allowed range, both ends included. */
  min?: number;
  max?: number;
  /** The range a slider should offer; typing may go beyond it, up to min and max. */
  soft_min?: number;
  soft_max?: number;
  /** A slider's step; 0 or absent: continuous. */
  step?: number;
  /** True where a slider should be logarithmic. */
  logarithmic?: boolean;
  /** Choices and subsets only. */
  options?: { value: string; title: string; help: string }[];
}

/** A number that a planner tells after each iteration. */
export interface Reading {
  name: string;
  /** TeX. */
  symbol: string;
  title: string;
  help: string;
  /** Where it belongs: a curve of costs, lengths (comparable with the exact optimum), a parameter's schedule, another
   * measure of the result, a count of particles. */
  group: 'cost' | 'length' | 'schedule' | 'measure' | 'count';
}

/** An equation of the paper. `live` holds `@name@` where a reading or an inspected value goes. */
export interface Formula {
  name: string;
  /** E.g. `[WCPSO] (3)`. */
  source: string;
  title: string;
  /** TeX, as in the paper. */
  tex: string;
  /** TeX with `@name@` placeholders for the numbers of the moment. Absent: nothing to put in. */
  live?: string;
  /** `iteration`: filled from the readings; `item`: filled from an inspection's values. */
  scope: 'iteration' | 'item';
  /** Shown only while this parameter has this value. */
  when?: When;
}

/** Parameters under a name: as published, or fitted to published figures. */
export interface Preset {
  name: string;
  title: string;
  help: string;
  /** A shipped scene on which to try it. */
  scene: string;
  /** The values that differ from the defaults. */
  params: Record<string, ParameterValue>;
}

export interface Planner {
  name: string;
  title: string;
  family: string;
  source: string;
  summary: string;
  kinds: Kind[];
  /** It calls at a scene's stops instead of going from start to goal: grids need two stops at least. */
  stops: boolean;
  /** The most stops that it can do with. Absent: as many as a scene may have. */
  most_stops?: number;
  parameters: Parameter[];
  presets: Preset[];
  readings: Reading[];
  formulas: Formula[];
  /** Layers it can draw, in drawing order. A frame's span table counts them from 0. */
  layers: Layer[];
  /** Layers that only its explanations mark. */
  marks: Layer[];
  /** The numbers that it tells of each of those that search side by side; empty: none. */
  members: Member[];
  /** The kinds of events that it tells of. */
  events: EventKind[];
}

/** A number of each of those that search side by side. */
export interface Member {
  name: string;
  /** TeX. */
  symbol: string;
  title: string;
  help: string;
  /** From 0 to this: to be drawn as a bar. */
  full?: number;
  /** What the numbers 0, 1, … stand for, if they are not numbers. */
  words?: string[];
}

/** A kind of event in simulated time. */
export interface EventKind {
  name: string;
  title: string;
  help: string;
  /** How it is to be taken: it came about, it calls for a decision, it is one, it is as it should be, it must not happen. */
  tone: 'plain' | 'warning' | 'decision' | 'good' | 'bad';
}

/** A colour by day, on a light ground, and by night: `#rrggbb` or `#rrggbbaa`. */
export interface Color {
  light: string;
  dark: string;
}

/** How a layer looks. Lengths are in pixels. */
export interface Look {
  color: Color;
  /** Of what a disc, a band, a robot or a sign covers. */
  fill?: Color;
  /** Of lines. */
  width: number;
  /** The diameter of a point. */
  point: number;
  /** Of a weight of 0, and of a weight of 1: from 0 (invisible) to 1. */
  opacity: [number, number];
  /** Layers of a higher order are drawn later. */
  order: number;
  /** Lengths of dashes and gaps, in turn. Absent: solid. */
  dash?: number[];
  /** A form of its own: points as a ring or diamond, stops with their `number`, lines with `arrow` heads; tubes as a `disc`, what they cover
   * (`band`) or its rim (`reach`); a `robot`; a sign for an `event`. Absent: plain. */
  glyph?: 'ring' | 'diamond' | 'number' | 'arrow' | 'disc' | 'band' | 'reach' | 'robot' | 'event';
  /** A field's colours: of its smallest value, the middle and the largest. */
  ramp?: [Color, Color, Color];
  /** The ramp is that of the values' square root. */
  root?: true;
  /** Lines grow from `width` to this with their weight. */
  swell?: number;
  /** Drawn only for the part of the plane that `lookAt` gives. */
  near?: true;
  /** Lifted off what lies beneath by a rim. */
  lifted?: true;
  /** How its vertices belong together, if that does not depend on the scene. */
  shape?: 'points' | 'polyline' | 'segments' | 'field' | 'tube';
  /** It shows the planner's result. The highest of several is what is handed over. */
  result?: number;
}

/** A layer: its key, how to name it in a legend, and how it looks. */
export interface Layer {
  /** Its key: what frames, items and marks call it. */
  role: string;
  title: string;
  help: string;
  /** Drawn without being asked for. */
  on: boolean;
  /** Its pieces can be picked and inspected. */
  pickable: boolean;
  /** It is drawn only while a parameter has this value. */
  when?: When;
  /** It is drawn only on these kinds of scene. */
  kinds?: Kind[];
  /** What its vertices' weight means: how much worse than the best of the moment (0 to 1), a share, a length or cost, an amount of pheromone,
   * a place in the best tour, half a tube's width, seconds, whether a walk arrived. Absent: nothing. */
  weight?: 'rank' | 'share' | 'length' | 'pheromone' | 'place' | 'half-width' | 'time' | 'arrived';
  look: Look;
}

export interface Catalogue {
  /** The crate's version. */
  version: string;
  planners: Planner[];
  /** The scenes that ship. */
  scenes: Scene[];
  /** What can make a random grid. */
  generators: Generator[];
  /** How a robot drives along what a planner found. */
  drive: DriveEntry;
  /** How an arm follows what a planner found. */
  motion: DriveEntry;
  /** The keys of all layers. A frame's span table counts its planner's `layers`, not these. */
  roles: string[];
  /** Layers of a scene itself, whatever the planner draws: exact optimum, printed path, moving obstacles, arm. */
  layers: Layer[];
  /** Every TeX string that stands outside a formula, so that a page can typeset them when it is built. */
  symbols: string[];
  /** Names of shape numbers in a frame's span table. */
  shapes: ('points' | 'polyline' | 'segments' | 'field' | 'tube')[];
}
