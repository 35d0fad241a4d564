import type { GridScene, Moving, Point, Robot } from 'forage-lab'
import { rounded } from './edits'
import { movingOf, withMoving } from './moving'

/* What is done to moving obstacles alone: loaded with the first grid. */

/** A part of a cell: by how much a key moves an obstacle, or its speed. */
const STEP = 1 / 4
/** A hand is not finer than about this part of a cell. */
const FINE = 1 / 50

const TEN = 10

/** A number that a hand gave, as short as it is fine: a tenth in cells of 20, a hundredth in cells of 1. */
function neat({ cell }: GridScene, value: number): number {
  const digits = TEN ** -Math.floor(Math.log10(cell * FINE))
  return rounded(Math.round(value * digits) / digits)
}

/** A place that a hand gave. */
export const neatly = (scene: GridScene, [x, y]: Point): Point => [neat(scene, x), neat(scene, y)]

/** How far a key moves an obstacle. */
export const strideOf = ({ cell }: GridScene): number => STEP * cell

/** Where an obstacle's centre would be after a second; nothing where way-points say where it goes. */
export const tipOf = ({ center, velocity }: Moving): Point | null => (velocity ? [center[0] + velocity[0], center[1] + velocity[1]] : null)

/** The scene with one of its obstacles changed. */
export function changed(scene: GridScene, index: number, change: (moving: Moving) => Moving): GridScene {
  return withMoving(scene, (all) => all.map((one, at) => (at === index ? change(one) : one)))
}

/** Its velocity; one that goes from way-point to way-point has none, and keeps to them. */
export const aimed = (scene: GridScene, index: number, velocity: Point): GridScene =>
  changed(scene, index, (one) => (one.velocity ? { ...one, velocity: [rounded(velocity[0]), rounded(velocity[1])] } : one))

/** Faster by steps to the right and upwards in the scene's own y. */
export function steered(scene: GridScene, index: number, [right, up]: Point): GridScene {
  const [x, y] = movingOf(scene)[index]?.velocity ?? [0, 0]
  const step = strideOf(scene)
  return aimed(scene, index, [x + right * step, y + up * step])
}

/** Its radius. */
export const widened = (scene: GridScene, index: number, radius: number): GridScene =>
  changed(scene, index, (one) => ({ ...one, radius: rounded(radius) }))

/** How fast it sets out: its velocity, or that of its first stretch. */
export function settingOut({ center, velocity, waypoints }: Moving): Point {
  const [first] = waypoints ?? []
  if (velocity || !first) return velocity ?? [0, 0]
  const [time, x, y] = first
  return [(x - center[0]) / time, (y - center[1]) / time]
}

/** It forgets its way-points and goes on as it sets out. */
export const straightened = (scene: GridScene, index: number): GridScene =>
  changed(scene, index, ({ waypoints, ...one }) => aimedAs(one, settingOut({ ...one, ...(waypoints && { waypoints }) })))

const aimedAs = (one: Moving, [x, y]: Point): Moving => ({ ...one, velocity: [rounded(x), rounded(y)] })

/** The scene with another one, as large as the last that there is. */
export function added(scene: GridScene, center: Point, velocity: Point): GridScene {
  const radius = movingOf(scene).at(-1)?.radius ?? strideOf(scene)
  return withMoving(scene, (all) => [...all, { center: neatly(scene, center), radius, velocity: neatly(scene, velocity) }])
}

/** What of a robot matters where something moves. */
export const ROBOT = ['speed', 'turn_time', 'sensor', 'radius', 'margin', 'look_ahead'] as const

/** The scene's robot with another value, or left to what robots usually have. */
export function equipped(scene: GridScene, name: keyof Robot, value: number | undefined): GridScene {
  const { robot: { [name]: _before, ...others } = {}, ...rest } = scene
  const robot: Robot = value === undefined ? others : { ...others, [name]: value }
  return Object.keys(robot).length > 0 ? { ...rest, robot } : rest
}
