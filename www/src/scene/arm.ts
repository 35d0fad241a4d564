import type { ArmScene, Cuboid, Point3 } from 'forage-lab'
import { rounded, type Selection } from './edits'

/* What is done to the scene of an arm: loaded with the first one. */

export type Axis = 0 | 1 | 2
export const AXES: readonly Axis[] = [0, 1, 2]
/** A face of a cuboid: the axis that it is square to, and which of the two. */
export interface Face {
  axis: Axis
  side: 'min' | 'max'
}
export const FACES: readonly Face[] = AXES.flatMap((axis) => (['min', 'max'] as const).map((side) => ({ axis, side })))

/** A cuboid is at least so long, in metres. */
export const LEAST_SIDE = 0.01
/** So long is a new one, unless the workspace is small. */
const NEW_SIDE = 0.2

const map = (change: (axis: Axis) => number): Point3 => [change(0), change(1), change(2)]
const neat = (at: Point3): Point3 => map((axis) => rounded(at[axis]))
const clamp = (value: number, low: number, high: number): number => Math.min(Math.max(value, low), Math.max(low, high))

export const middle = ({ min, max }: Cuboid): Point3 => map((axis) => (min[axis] + max[axis]) / 2)
export const sides = ({ min, max }: Cuboid): Point3 => map((axis) => max[axis] - min[axis])

/** What can be selected in it, in the order in which keys go from one to the next. */
export const objects = (scene: ArmScene): Selection[] => [
  { kind: 'start' },
  { kind: 'goal' },
  ...scene.cuboids.map((_, index): Selection => ({ kind: 'cuboid', index })),
  { kind: 'base' },
]

/** Where something of the scene is; a cuboid's middle. */
export function whereIs(scene: ArmScene, selection: Selection): Point3 | null {
  if (selection.kind === 'start' || selection.kind === 'goal') return scene[selection.kind]
  if (selection.kind === 'base') return scene.arm.base.position
  const cuboid = selection.kind === 'cuboid' ? scene.cuboids[selection.index] : undefined
  return cuboid ? middle(cuboid) : null
}

/** Moves something. All stays inside the workspace, as a cuboid's middle does. */
export function moved(scene: ArmScene, selection: Selection, to: Point3): ArmScene {
  const { min, max } = scene.workspace
  const at = neat(map((axis) => clamp(to[axis], min[axis], max[axis])))
  if (selection.kind === 'start' || selection.kind === 'goal') return { ...scene, [selection.kind]: at }
  if (selection.kind === 'base') return withBase(scene, { position: at })
  if (selection.kind !== 'cuboid') return scene
  return withCuboid(scene, selection.index, (cuboid) => {
    const from = middle(cuboid)
    const shift = (corner: Point3): Point3 => neat(map((axis) => corner[axis] + at[axis] - from[axis]))
    return { min: shift(cuboid.min), max: shift(cuboid.max) }
  })
}

/** A cuboid with one of its faces elsewhere along its axis. */
export function faced(scene: ArmScene, index: number, { axis, side }: Face, to: number): ArmScene {
  return withCuboid(scene, index, (cuboid) => {
    const [low, high] = side === 'min' ? [-Infinity, cuboid.max[axis] - LEAST_SIDE] : [cuboid.min[axis] + LEAST_SIDE, Infinity]
    return { ...cuboid, [side]: map((other) => (other === axis ? rounded(clamp(to, low, high)) : cuboid[side][other])) }
  })
}

/** The scene with one of its cuboids changed. */
export function withCuboid(scene: ArmScene, index: number, change: (cuboid: Cuboid) => Cuboid): ArmScene {
  return { ...scene, cuboids: scene.cuboids.map((cuboid, at) => (at === index ? change(cuboid) : cuboid)) }
}

/** The scene with another cuboid that stands about here. */
export function added(scene: ArmScene, [x, y, z]: Point3): ArmScene {
  const { min, max } = scene.workspace
  const side = map((axis) => Math.min(NEW_SIDE, (max[axis] - min[axis]) / 3))
  const low = map((axis) => clamp([x - side[0] / 2, y - side[1] / 2, z][axis] ?? 0, min[axis], max[axis] - side[axis]))
  return { ...scene, cuboids: [...scene.cuboids, { min: neat(low), max: neat(map((axis) => low[axis] + side[axis])) }] }
}

/** The scene without a cuboid; the same where there is nothing to remove. */
export function without(scene: ArmScene, selection: Selection | null): ArmScene {
  return selection?.kind === 'cuboid' ? { ...scene, cuboids: scene.cuboids.filter((_, at) => at !== selection.index) } : scene
}

/** The arm placed otherwise. */
export const withBase = (scene: ArmScene, base: Partial<ArmScene['arm']['base']>): ArmScene => ({
  ...scene,
  arm: { ...scene.arm, base: { ...scene.arm.base, ...base } },
})
