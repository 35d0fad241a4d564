import type { ArmScene, Cuboid, Point3 } from 'forage-lab'
import { type Axis, type Face, FACES, faced, middle, moved, whereIs } from '../../scene/arm'
import type { Selection } from '../../scene/edits'
import { along, dot, lengthOf, minus, times, type Vector } from '../../scene/vector'
import type { Camera, Ray } from './camera'
import { basis } from './orbit'

/** What of a scene in space can be taken hold of: its objects, a selected cuboid's faces, and the arrow that lifts what is selected. */
export type Grip = Selection | ({ kind: 'face'; index: number } & Face) | { kind: 'lift' }

type At = readonly [number, number]

/** Below this angle a hand can't tell near from far on the floor: it moves things upwards instead. Degrees. */
const FLAT = 12
/** The lifting arrow is so far above what it lifts, in pixels. */
export const LIFT = 40
/** A hand is as fine as a millimetre. */
const FINE = 1000

const neat = (value: number): number => Math.round(value * FINE) / FINE

/** The middle of a cuboid's face. */
export function faceOf(cuboid: Cuboid, { axis, side }: Face): Point3 {
  const at = middle(cuboid)
  at[axis] = cuboid[side][axis]
  return at
}

/** The faces that are turned to the eye. */
export function facing(cuboid: Cuboid, camera: Camera): Face[] {
  const { eye } = camera
  return FACES.filter(({ axis, side }) => (side === 'max' ? eye[axis] > cuboid.max[axis] : eye[axis] < cuboid.min[axis]))
}

/** Where the arrow is that lifts an object: above it on the screen. */
export function liftAt(scene: ArmScene, selection: Selection, camera: Camera): [number, number] | null {
  const cuboid = selection.kind === 'cuboid' ? scene.cuboids[selection.index] : undefined
  const at = cuboid ? faceOf(cuboid, { axis: 2, side: 'max' }) : whereIs(scene, selection)
  const seen = at && camera.project(at)
  return seen && [seen.x, seen.y - LIFT]
}

/** How far along a ray a box is; Infinity: it misses. */
export function distance({ origin, direction }: Ray, { min, max }: Cuboid): number {
  let [near, far] = [0, Infinity]
  for (let axis = 0; axis < 3; axis += 1) {
    const [from = 0, by = 0] = [origin[axis], direction[axis]]
    const [a, b] = [((min[axis] ?? 0) - from) / by, ((max[axis] ?? 0) - from) / by]
    if (Number.isNaN(a) || Number.isNaN(b)) continue
    near = Math.max(near, Math.min(a, b))
    far = Math.min(far, Math.max(a, b))
  }
  return near <= far ? near : Infinity
}

/** Whether a cuboid stands between the eye and a point. */
export function isHidden(scene: ArmScene, camera: Camera, at: Readonly<Point3>): boolean {
  const way = minus(at, camera.eye)
  const far = lengthOf(way)
  const ray = { origin: camera.eye, direction: times(way, 1 / far) }
  return scene.cuboids.some((cuboid) => distance(ray, cuboid) < far - 1e-3)
}

/** The column under the base, as a box. */
export function columnOf({ arm, workspace }: ArmScene): Cuboid {
  const { position, column_radius: radius = 0 } = arm.base
  const [x, y, z] = position
  return { min: [x - radius, y - radius, Math.min(workspace.min[2], z)], max: [x + radius, y + radius, z + radius / 2] }
}

/** Something that is held, from where it was taken hold of. */
export class Hold {
  private from: Vector
  private readonly anchor: Point3
  private across = false
  /** Where the hand was. */
  private last: At

  constructor(
    private readonly scene: ArmScene,
    readonly grip: Grip,
    private readonly selection: Selection,
    private readonly camera: Camera,
    at: At,
  ) {
    this.anchor = [...(whereIs(scene, selection) ?? [0, 0, 0])]
    this.last = at
    this.from = this.touch(at) ?? [...this.anchor]
  }

  /** The scene with it where the hand is now; `across`: upwards instead of over the floor. */
  carry(now: ArmScene, at: At, across: boolean): ArmScene {
    const { grip, selection } = this
    if (grip.kind === 'face') {
      const cuboid = this.scene.cuboids[grip.index]
      const along = cuboid && this.along(at, faceOf(cuboid, grip), grip.axis)
      return along == null ? now : faced(now, grip.index, grip, neat(along))
    }
    const to: Point3 = [...(whereIs(now, selection) ?? this.anchor)]
    // From here on the hand means another direction.
    if (grip.kind !== 'lift' && across !== this.across) this.anew(to, this.last, across)
    this.last = at
    if (grip.kind === 'lift' || across) {
      const height = this.along(at, this.from, 2)
      if (height !== null) to[2] = neat(this.anchor[2] + height - this.from[2])
      return moved(now, selection, to)
    }
    const touched = this.onPlane(at, this.from)
    if (!touched) return now
    const by = minus(touched, this.from)
    return moved(now, selection, [neat(this.anchor[0] + by[0]), neat(this.anchor[1] + by[1]), neat(this.anchor[2] + by[2])])
  }

  private anew(at: Point3, screen: At, across: boolean): void {
    this.across = across
    for (const axis of [0, 1, 2] as const) this.anchor[axis] = at[axis]
    this.from = this.onPlane(screen, at) ?? [...at]
    if (across) {
      const height = this.along(screen, at, 2)
      this.from = [at[0], at[1], height ?? at[2]]
    }
  }

  /** The point of the object that was touched. */
  private touch(at: At): Point3 | null {
    const { grip, selection, scene, camera } = this
    if (grip.kind === 'face') return null
    if (grip.kind === 'lift') {
      const height = this.along(at, this.anchor, 2)
      return height === null ? null : [this.anchor[0], this.anchor[1], height]
    }
    const box = selection.kind === 'cuboid' ? scene.cuboids[selection.index] : selection.kind === 'base' ? columnOf(scene) : undefined
    if (!box) return this.onPlane(at, this.anchor)
    const ray = camera.ray(at)
    const far = distance(ray, box)
    return Number.isFinite(far) ? along(ray.origin, ray.direction, far) : this.onPlane(at, this.anchor)
  }

  /** Where the hand is on the level plane through a point; seen from the side, on the upright one. */
  private onPlane(at: At, through: Vector): Point3 | null {
    const { orbit } = this.camera
    const { origin, direction } = this.camera.ray(at)
    const normal: Vector = Math.abs(orbit.elevation) < FLAT ? basis({ ...orbit, elevation: 0 })[2] : [0, 0, 1]
    const far = dot(minus(through, origin), normal) / dot(direction, normal)
    // Beyond the horizon, or nearly: a pixel would be metres.
    if (!(far > 0) || far > 4 * orbit.distance) return null
    return along(origin, direction, far)
  }

  /** Where along an axis through a point the hand is. */
  private along(at: At, through: Vector, axis: Axis): number | null {
    const { origin, direction } = this.camera.ray(at)
    const gap = minus(through, origin)
    const cos = direction[axis]
    const sin = 1 - cos * cos
    // Looked at along the axis, the hand can't say how far.
    if (sin < 1e-3) return null
    return through[axis] + (cos * dot(gap, direction) - gap[axis]) / sin
  }
}
