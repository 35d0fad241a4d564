/** How a role looks. The page knows roles, and no planner by name. */
export interface Style {
  /** A colour token. */
  colour: string
  width: number
  /** Higher is drawn later. */
  order: number
  dash?: number[]
  /** Side of a point's square, in pixels. */
  point: number
  /** Opacity of the best and of the worst by weight. */
  alpha: [number, number]
  /** Drawn with a mark of its own, so that colour isn't all that tells it apart. */
  mark?: 'ring' | 'diamond'
  /** Of what has a width, or a mark like no other: how the legend shows it. */
  area?: 'disc' | 'band' | 'reach' | 'robot' | 'event'
  /** Lines that are lifted off what lies beneath. */
  lifted?: true
  /** Points, also in a plane where most roles are lines. */
  dots?: true
  /** Lines grow from `width` to this with their weight. */
  swell?: number
  /** Drawn by the core only for the part of the plane that is seen. */
  near?: true
  /** Lines with a direction. */
  arrows?: true
  /** Values over the plane: the tokens of their colours from weak to strong. */
  ramp?: readonly string[]
}

/** Lines that something went along, a vertex a step. */
export const WALKED = 'ants'

/** The scene's own: drawn with start and goal, and numbered as this layer says. */
export const STOPS = 'stops'

const PLAIN: Style = { colour: '--ink-2', width: 1, order: 20, point: 3, alpha: [0.8, 0.8] }

const STYLES: Readonly<Record<string, Style>> = {
  closed: { colour: '--closed-high', ramp: ['--closed-low', '--closed', '--closed-high'], width: 1, order: 1, point: 3, alpha: [1, 1] },
  pheromone: {
    colour: '--pheromone-high',
    ramp: ['--pheromone-low', '--pheromone', '--pheromone-high'],
    width: 1,
    order: 2,
    point: 3,
    alpha: [1, 1],
  },
  trails: { colour: '--trail', width: 0.6, swell: 4, order: 4, near: true, point: 3, alpha: [0, 1] },
  guides: { colour: '--guide', width: 1, order: 5, dash: [2, 4], point: 3, alpha: [1, 1] },
  'personal-bests': { colour: '--accent', width: 0.75, order: 10, point: 2.5, alpha: [0.35, 0.35] },
  velocities: { colour: '--inertia', width: 0.75, order: 25, point: 2, alpha: [0.55, 0.55] },
  roads: { colour: '--road', width: 1.5, order: 12, point: 3, alpha: [0.55, 0.55] },
  tours: { colour: '--particle', width: 1, order: 19, point: 3, alpha: [0.22, 0.22] },
  frontier: { colour: '--frontier', width: 1, order: 16, dots: true, point: 4, alpha: [0.9, 0.9] },
  tree: { colour: '--tree', width: 1, order: 14, point: 3, alpha: [0.7, 0.7] },
  'goal-tree': { colour: '--goal-tree', width: 1, order: 15, dash: [5, 2], point: 3, alpha: [0.8, 0.8] },
  nodes: { colour: '--tree', width: 1, order: 17, dots: true, point: 4, alpha: [0.75, 0.75] },
  ants: { colour: '--ant', width: 0.9, order: 18, point: 5, alpha: [0.14, 0.5] },
  particles: { colour: '--particle', width: 1, order: 20, point: 5, alpha: [0.55, 0.1] },
  attractors: { colour: '--attractor', width: 1, order: 22, dash: [8, 2, 1, 2], point: 4, alpha: [0.6, 0.6] },
  selected: { colour: '--selected', width: 1.6, order: 29, point: 6, alpha: [0.9, 0.9], mark: 'diamond' },
  hen: { colour: '--hen', width: 1.6, order: 30, point: 5, alpha: [0.9, 0.9], mark: 'ring' },
  chick: { colour: '--chick', width: 1.6, order: 31, dash: [7, 3], point: 5, alpha: [0.95, 0.95], mark: 'diamond' },
  'mean-best': { colour: '--mean', width: 2.25, order: 33, dash: [7, 4], point: 8, alpha: [1, 1], mark: 'diamond' },
  exact: { colour: '--exact', width: 1.75, order: 35, dash: [2, 5], point: 4, alpha: [1, 1] },
  printed: { colour: '--printed', width: 2.25, order: 36, dash: [10, 5], point: 4, alpha: [1, 1] },
  best: { colour: '--best', width: 3, order: 40, point: 9, alpha: [1, 1], mark: 'ring' },
  smoothed: { colour: '--best', width: 3.25, order: 41, point: 9, alpha: [1, 1], mark: 'ring' },
  tour: { colour: '--best', width: 2.75, order: 40, arrows: true, point: 9, alpha: [1, 1] },
  predicted: { colour: '--predicted-edge', width: 1.25, order: 7, area: 'band', point: 3, alpha: [1, 1] },
  sensor: { colour: '--robot', width: 1.25, order: 8, dash: [3, 6], area: 'reach', point: 3, alpha: [0.7, 0.7] },
  ahead: { colour: '--robot', width: 2, order: 42, dash: [1, 5], lifted: true, point: 3, alpha: [1, 1] },
  track: { colour: '--robot', width: 2.5, order: 43, lifted: true, point: 3, alpha: [1, 1] },
  moving: { colour: '--moving', width: 2, order: 44, area: 'disc', point: 9, alpha: [1, 1] },
  'local-goal': { colour: '--robot', width: 2, order: 46, dots: true, point: 13, alpha: [1, 1], mark: 'diamond' },
  events: { colour: '--ink', width: 1.5, order: 47, area: 'event', point: 13, alpha: [1, 1] },
  arm: { colour: '--robot', width: 4, order: 48, point: 9, alpha: [1, 1] },
  robot: { colour: '--robot', width: 2.25, order: 48, area: 'robot', point: 9, alpha: [1, 1] },
  [STOPS]: { colour: '--stop', width: 2, order: 45, dots: true, point: 9, alpha: [1, 1], mark: 'ring' },
  candidates: { colour: '--ant', width: 1.75, order: 49, point: 3, alpha: [0.8, 0.8] },
  samples: { colour: '--sample', width: 1, order: 37, dots: true, point: 5, alpha: [0.85, 0.85] },
  kept: { colour: '--kept', width: 1.5, order: 38, dots: true, point: 8, alpha: [1, 1], mark: 'ring' },
  chosen: { colour: '--chosen', width: 2, order: 39, dots: true, point: 11, alpha: [1, 1], mark: 'diamond' },
  before: { colour: '--ink', width: 1.5, order: 50, dash: [3, 3], point: 6, alpha: [0.7, 0.7] },
  after: { colour: '--ink', width: 2, order: 51, point: 7, alpha: [1, 1] },
  inertia: { colour: '--inertia', width: 2, order: 52, point: 3, alpha: [1, 1] },
  cognitive: { colour: '--cognitive', width: 2, order: 53, point: 3, alpha: [1, 1] },
  social: { colour: '--social', width: 2, order: 54, point: 3, alpha: [1, 1] },
  velocity: { colour: '--ink', width: 1.5, order: 55, dash: [5, 3], point: 3, alpha: [1, 1] },
  different: { colour: '--different', width: 2, order: 57, dots: true, point: 27, alpha: [1, 1], mark: 'ring' },
  jump: { colour: '--hen', width: 2.25, order: 56, point: 3, alpha: [1, 1] },
}

/** The best where a smoothed path is the result: how that came about. */
const RAW: Partial<Style> = { width: 1.5, alpha: [0.75, 0.75], dash: [1, 4] }

/** Which of the roles that are shown is the result. */
export const resultOf = (shown: readonly string[]): string => ['smoothed', 'tour'].find((role) => shown.includes(role)) ?? 'best'

/** In an inspection there is only one of each: it is drawn clearly. */
export function closer(role: string): Style {
  const style = styleOf(role)
  return { ...style, width: Math.max(style.width, 1.75), alpha: [Math.max(style.alpha[0], 0.85), 1] }
}

/** A role's style beside the role that is the result. */
export function styleBeside(role: string, result: string): Style {
  return role === 'best' && result !== 'best' ? { ...styleOf(role), ...RAW } : styleOf(role)
}

export const styleOf = (role: string): Style => STYLES[role] ?? PLAIN
