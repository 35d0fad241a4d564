import type { FormulaScene, NamedFunctionScene, SuiteFunctionScene, Point, Scene } from 'forage-lab'
import { stopsOf } from '../scene/stops'

/** Which part of the plane is seen: the middle, and how many pixels a unit is. */
export interface View {
  x: number
  y: number
  scale: number
  /** y grows downwards, as in pictures. */
  down?: boolean
}

export interface Size {
  width: number
  height: number
}

/** A place seen from above: what else it has is left out. */
export type Flat = readonly [x: number, y: number, ...rest: number[]]

export interface Box {
  min: Point
  max: Point
}

/** How small and how large a scene may be shown, 1 being as a whole. */
export const ZOOM = { least: 0.2, most: 400 }

/** Half the side of the box that a named function is searched in, as its definition says. */
const REACH: Readonly<Record<NamedFunctionScene['function'], number>> = {
  matyas: 10,
  'egg-crate': 2 * Math.PI,
  sphere: 100,
  rosenbrock: 4,
  ackley: 32,
  rastrigin: 5.12,
}

/** The same of the functions of the suite bbob. */
const SUITE = 5

const isNamed = (scene: NamedFunctionScene | SuiteFunctionScene): scene is NamedFunctionScene => scene.function in REACH

/** Where a scene takes place. */
export function extent(scene: Scene): Box {
  if (scene.kind === 'discs') return scene.bounds
  if (scene.kind === 'grid') return { min: [0, 0], max: [(scene.rows[0]?.length ?? 1) * scene.cell, scene.rows.length * scene.cell] }
  if (scene.kind === 'tour') return around(stopsOf(scene))
  if (scene.kind === 'arm')
    return { min: [scene.workspace.min[0], scene.workspace.min[1]], max: [scene.workspace.max[0], scene.workspace.max[1]] }
  if ('expression' in scene) return sides(scene)
  const reach = isNamed(scene) ? REACH[scene.function] : SUITE
  return { min: [-reach, -reach], max: [reach, reach] }
}

/** The first two sides of a search box; a single one twice, about 0. */
function sides({ bounds: { min, max }, dimension }: FormulaScene): Box {
  const [left, right] = [min, max].map((side) => (typeof side === 'number' ? side : (side[0] ?? 0))) as [number, number]
  const half = (right - left) / 2
  const [bottom, top] = [min, max].map((side) => (typeof side === 'number' ? side : (side[1] ?? 0))) as [number, number]
  return dimension === 1 ? { min: [left, -half], max: [right, half] } : { min: [left, bottom], max: [right, top] }
}

/** All places with a margin, as the core has it. */
function around(places: readonly Point[]): Box {
  const [low, high] = [Math.min, Math.max].map((of) =>
    [0, 1].map((axis) => places.reduce((found, at) => of(found, at[axis] ?? 0), places[0]?.[axis] ?? 0)),
  )
  const [[left = 0, bottom = 0] = [], [right = 0, top = 0] = []] = [low, high]
  const margin = 0.05 * Math.max(right - left, top - bottom) || 1
  return { min: [left - margin, bottom - margin], max: [right + margin, top + margin] }
}

/** Whether a scene's y grows downwards. */
export const isDown = (scene: Scene): boolean => scene.kind === 'grid' && scene.y_axis !== 'up'

/** What y has to be multiplied by to grow upwards on the screen. */
export const rise = ({ down }: View): 1 | -1 => (down ? -1 : 1)

/** Left free about a scene that is shown whole, in pixels; below as much as above unless it says otherwise. */
export type Margins = readonly [beside: number, above: number, below?: number]

/** On a stage of at least this width tools stand in a column; on others they lie below. */
const WIDE = 720

/** Room about a scene for labels and, unless the stage is bare, tools. */
export const margins = (width: number, bare: boolean): Margins => (bare ? [30, 28] : width > WIDE ? [64, 38] : [38, 38, 76])

/** The view that shows the whole box. */
export function fit({ min, max }: Box, { width, height }: Size, [beside, above, below = above]: Margins, down = false): View {
  const fitting = Math.min((width - 2 * beside) / (max[0] - min[0]), (height - above - below) / (max[1] - min[1]))
  const scale = Math.max(fitting, 1e-6)
  const lifted = ((below - above) / 2 / scale) * (down ? 1 : -1)
  return { x: (min[0] + max[0]) / 2, y: (min[1] + max[1]) / 2 + lifted, scale, down }
}

export const toScreen = (view: View, { width, height }: Size, at: Flat): Point => [
  width / 2 + (at[0] - view.x) * view.scale,
  height / 2 - rise(view) * (at[1] - view.y) * view.scale,
]

export const toScene = (view: View, { width, height }: Size, at: Point): Point => [
  view.x + (at[0] - width / 2) / view.scale,
  view.y - (rise(view) * (at[1] - height / 2)) / view.scale,
]

export const pan = (view: View, dx: number, dy: number): View => ({
  ...view,
  x: view.x - dx / view.scale,
  y: view.y + (rise(view) * dy) / view.scale,
})

/** Zooms so that what is under `at` stays there. `whole` is the scale at which all is seen. */
export function zoom(view: View, size: Size, by: number, at: Point, whole: number): View {
  const scale = Math.min(Math.max(view.scale * by, whole * ZOOM.least), whole * ZOOM.most)
  const [x, y] = toScene(view, size, at)
  return {
    ...view,
    scale,
    x: x - (at[0] - size.width / 2) / scale,
    y: y + (rise(view) * (at[1] - size.height / 2)) / scale,
  }
}

/** A round step for ticks that lie about `pixels` apart. */
export function tick(scale: number, pixels: number): number {
  const raw = pixels / scale
  const power = 10 ** Math.floor(Math.log10(raw))
  const lead = raw / power
  return power * (lead <= 1 ? 1 : lead <= 2 ? 2 : lead <= 5 ? 5 : 10)
}
