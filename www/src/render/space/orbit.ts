import { MathUtils, Matrix4, type PerspectiveCamera, Vector3 } from 'three'
import type { Cuboid, Point3 } from 'forage-lab'
import type { Margins, Size } from '../view'

/** From where space is seen: a point on a sphere about what is looked at. Angles are degrees. */
export interface Orbit {
  target: Point3
  distance: number
  /** The camera's direction about z, from x. */
  azimuth: number
  /** Above the floor. */
  elevation: number
}

export type Side = 'corner' | 'front' | 'side' | 'top'
export const SIDES: Readonly<Record<Side, Pick<Orbit, 'azimuth' | 'elevation'>>> = {
  corner: { azimuth: -62, elevation: 27 },
  front: { azimuth: -90, elevation: 0 },
  side: { azimuth: 0, elevation: 0 },
  top: { azimuth: -90, elevation: 90 },
}

/** The vertical field of view: long lenses leave parallels nearly parallel. */
export const FIELD_OF_VIEW = 26
/** How far below the floor one may look up from. */
const LOWEST = -20
const ZOOM = { least: 0.12, most: 4 }

const slope = Math.tan(MathUtils.degToRad(FIELD_OF_VIEW / 2))

/** To the right, upwards, and towards the eye. */
export function basis({ azimuth, elevation }: Pick<Orbit, 'azimuth' | 'elevation'>): [right: Vector3, up: Vector3, back: Vector3] {
  const [turn, rise] = [MathUtils.degToRad(azimuth), MathUtils.degToRad(elevation)]
  const back = new Vector3(Math.cos(rise) * Math.cos(turn), Math.cos(rise) * Math.sin(turn), Math.sin(rise))
  const right = new Vector3(-Math.sin(turn), Math.cos(turn), 0)
  return [right, new Vector3().crossVectors(back, right), back]
}

/** Puts a camera there. Straight from above there is an up, too. */
export function aim(camera: PerspectiveCamera, orbit: Orbit): void {
  const [right, up, back] = basis(orbit)
  camera.position.set(...orbit.target).addScaledVector(back, orbit.distance)
  camera.quaternion.setFromRotationMatrix(new Matrix4().makeBasis(right, up, back))
  camera.near = orbit.distance / 50
  camera.far = orbit.distance * 8
  camera.updateProjectionMatrix()
  camera.updateMatrixWorld()
}

/** An orbit as near, far and high as one can go by hand; `whole`: how far away all is seen. */
export const bounded = (orbit: Orbit, whole: number): Orbit => ({
  ...orbit,
  distance: MathUtils.clamp(orbit.distance, whole * ZOOM.least, whole * ZOOM.most),
  elevation: MathUtils.clamp(orbit.elevation, LOWEST, 90),
})

/** Metres that a pixel is wide, where it is looked at. */
export const pixel = ({ distance }: Orbit, { height }: Size): number => (2 * slope * distance) / Math.max(1, height)

/** The orbit on a side from which all of a box is seen. Margins are pixels. */
export function fit(box: Cuboid, { width, height }: Size, [beside, above]: Margins, side: Pick<Orbit, 'azimuth' | 'elevation'>): Orbit {
  const [right, up, back] = basis(side)
  const target = new Vector3().addVectors(new Vector3(...box.min), new Vector3(...box.max)).multiplyScalar(0.5)
  const across = (slope * Math.max(40, width - 2 * beside)) / height
  const along = (slope * Math.max(40, height - 2 * above)) / height
  let orbit: Orbit = { ...side, target: [target.x, target.y, target.z], distance: 1 }
  // Perspective makes the near side larger: what is seen is centred again.
  for (let pass = 0; pass < 3; pass += 1) {
    let distance = 0.01
    let [low, high, left, far] = [Infinity, -Infinity, Infinity, -Infinity]
    const seen = corners(box).map((corner) => corner.sub(target))
    for (const at of seen)
      distance = Math.max(distance, at.dot(back) + Math.abs(at.dot(right)) / across, at.dot(back) + Math.abs(at.dot(up)) / along)
    for (const at of seen) {
      const depth = distance - at.dot(back)
      ;[low, high] = [Math.min(low, at.dot(up) / depth), Math.max(high, at.dot(up) / depth)]
      ;[left, far] = [Math.min(left, at.dot(right) / depth), Math.max(far, at.dot(right) / depth)]
    }
    target.addScaledVector(up, ((low + high) / 2) * distance).addScaledVector(right, ((left + far) / 2) * distance)
    orbit = { ...side, target: [target.x, target.y, target.z], distance }
  }
  return orbit
}

function corners({ min, max }: Cuboid): Vector3[] {
  return Array.from({ length: 8 }, (_, at) => new Vector3(at & 1 ? max[0] : min[0], at & 2 ? max[1] : min[1], at & 4 ? max[2] : min[2]))
}

export function turned(orbit: Orbit, azimuth: number, elevation: number): Orbit {
  return { ...orbit, azimuth: orbit.azimuth + azimuth, elevation: MathUtils.clamp(orbit.elevation + elevation, LOWEST, 90) }
}

/** What is looked at goes with the hand. */
export function shifted(orbit: Orbit, size: Size, dx: number, dy: number): Orbit {
  const [right, up] = basis(orbit)
  const each = pixel(orbit, size)
  const { x, y, z } = new Vector3(...orbit.target).addScaledVector(right, -dx * each).addScaledVector(up, dy * each)
  return { ...orbit, target: [x, y, z] }
}

/** Nearer, so that what is under `at` stays about there. `whole` is the distance from which all is seen. */
export function zoomed(orbit: Orbit, size: Size, by: number, at: readonly [number, number], whole: number): Orbit {
  const distance = MathUtils.clamp(orbit.distance / by, whole * ZOOM.least, whole * ZOOM.most)
  const share = 1 - distance / orbit.distance
  const nearer = shifted(orbit, size, -(at[0] - size.width / 2) * share, -(at[1] - size.height / 2) * share)
  return { ...nearer, distance }
}

/** On the way from one orbit to another, the short way round. */
export function between(from: Orbit, to: Orbit, share: number): Orbit {
  const mix = (a: number, b: number): number => MathUtils.lerp(a, b, share)
  const turn = MathUtils.euclideanModulo(to.azimuth - from.azimuth + 180, 360) - 180
  return {
    target: [mix(from.target[0], to.target[0]), mix(from.target[1], to.target[1]), mix(from.target[2], to.target[2])],
    distance: mix(from.distance, to.distance),
    azimuth: from.azimuth + turn * share,
    elevation: mix(from.elevation, to.elevation),
  }
}
