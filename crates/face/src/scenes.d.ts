/** A point [x, y] in the scene's unit. */
export type Point = [number, number];

/** What a scene is made of. Planners say which kinds they run on. */
export type Kind = 'function' | 'discs' | 'grid' | 'tour' | 'arm';

/** A point [x, y, z] in space. */
export type Point3 = [number, number, number];

interface SceneBase {
  format: 'forage-scene';
  version: 1;
  /** Short identifier, used in links and on the command line. */
  name: string;
  title: string;
  note?: string;
  source?: string;
  units?: string;
  /** The stored optimum, if the file carries one. */
  exact?: { length?: number; order?: number[]; tip_length?: number; straight?: number };
  /** Figures published for this scene, as they stand in the file. */
  published?: Record<string, unknown>;
}

/** A test function to minimise. */
export interface FunctionScene extends SceneBase {
  kind: 'function';
  function: 'matyas' | 'egg-crate' | 'sphere' | 'rosenbrock' | 'ackley' | 'rastrigin';
  dimension: number;
  /** Where the function's origin is, a number for each variable; without it at 0. */
  shift?: number[];
}

export interface Disc {
  center: Point;
  radius: number;
}

/** A plane with circular obstacles. */
export interface DiscsScene extends SceneBase {
  kind: 'discs';
  bounds: { min: Point; max: Point };
  start: Point;
  goal: Point;
  discs: Disc[];
}

/** The robot of a grid scene. Its radius is that of the circle about `length` × `width`; without them it is a point. */
export interface Robot {
  length?: number;
  width?: number;
  speed?: number;
  turn_time?: number;
  /** How far it sees. */
  sensor?: number;
  /** The radius of the disc that it is for moving obstacles. */
  radius?: number;
  /** How far it keeps them away beyond that. */
  margin?: number;
  /** How many seconds it looks ahead. */
  look_ahead?: number;
}

/** A disc that moves: at an even speed, or from way-point to way-point. */
export interface Moving {
  /** Where its centre is at time 0. */
  center: Point;
  radius: number;
  /** How far it goes in a second. */
  velocity?: Point;
  /** Instead of a velocity: [t, x, y] by growing t > 0; at the last it stays. */
  waypoints?: [number, number, number][];
}

/** A grid of free and blocked cells. The grid covers (0, 0) to (columns · cell, rows · cell). */
export interface GridScene extends SceneBase {
  kind: 'grid';
  /** A cell's side, in the scene's unit. */
  cell: number;
  /** Top row first; `.` free, `#` blocked. */
  rows: string[];
  /** `down` (default): origin at the top left; `up`: at the bottom left. A checked scene always says. */
  y_axis?: 'down' | 'up';
  start?: Point;
  goal?: Point;
  stops?: Point[];
  corner_cutting?: boolean;
  robot?: Robot;
  moving?: Moving[];
}

/** Stops to call at: points in the plane, or a matrix of their distances (with points or without). */
export interface TourScene extends SceneBase {
  kind: 'tour';
  points?: Point[];
  /** How far it is between points. All but `euclidean` are TSPLIB's, in whole numbers; of `geo` a point is [longitude, latitude]
   * as degrees and minutes, DDD.MM. */
  metric?: 'euclidean' | 'euc-2d' | 'ceil-2d' | 'att' | 'geo';
  /** Distances, the same there and back. */
  matrix?: number[][];
  /** Whether a tour goes back to where it began. Default true. */
  closed?: boolean;
}

/** An axis-parallel box in space. */
export interface Cuboid {
  min: Point3;
  max: Point3;
}

/** A joint and the link before it, modified Denavit–Hartenberg: T = Rx(alpha) Tx(a) Rz(θ) Tz(d). Metres and degrees. */
export interface Joint {
  a: number;
  alpha: number;
  /** θ in the home posture. */
  home: number;
  d: number;
  min: number;
  max: number;
  /** Degrees a second at most. Default 180. */
  speed?: number;
}

/** A six-axis arm with a spherical wrist. */
export interface Arm {
  joints: Joint[];
  /** A straight piece from the wrist to the tip along an axis of the last frame. */
  tool: { axis: 'x' | 'y' | 'z'; length: number };
  /** World = position + Rz(yaw) (x, y, z). The column stands between the workspace's floor and the base. */
  base: { position: Point3; yaw?: number; column_radius?: number };
}

/** An arm whose tip goes from start to goal among cuboids. Metres, degrees, z upwards. */
export interface ArmScene extends SceneBase {
  kind: 'arm';
  workspace: Cuboid;
  start: Point3;
  goal: Point3;
  /** A checked scene always has the list. */
  cuboids: Cuboid[];
  arm: Arm;
}

/** A scene file's content. */
export type Scene = FunctionScene | DiscsScene | GridScene | TourScene | ArmScene;
