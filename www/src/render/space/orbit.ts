import type { Cuboid, Point3 } from 'forage-lab'
import { along, clamp, cross, dot, minus, plus, radians, times } from '../../scene/vector'
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
/** Half of it, as a slope. */
export const SLOPE = Math.tan(radians(FIELD_OF_VIEW / 2))
/** Nearer to the eye nothing is seen, as a share of how far it looks; nor farther than so many times that. */
export const [NEAR, FAR] = [1 / 50, 8]
/** How far below the floor one may look up from. */
const LOWEST = -20
const ZOOM = { least: 0.12, most: 4 }

/** To the right, upwards, and towards the eye. Straight from above there is an up, too. */
export function basis({ azimuth, elevation }: Pick<Orbit, 'azimuth' | 'elevation'>): [right: Point3, up: Point3, back: Point3] {
  const [turn, rise] = [radians(azimuth), radians(elevation)]
  const back: Point3 = [Math.cos(rise) * Math.cos(turn), Math.cos(rise) * Math.sin(turn), Math.sin(rise)]
  const right: Point3 = [-Math.sin(turn), Math.cos(turn), 0]
  return [right, cross(back, right), back]
}

/** Where the eye is. */
export const eyeOf = (orbit: Orbit): Point3 => along(orbit.target, basis(orbit)[2], orbit.distance)

/** An orbit as near, far and high as one can go by hand; `whole`: how far away all is seen. */
export const bounded = (orbit: Orbit, whole: number): Orbit => ({
  ...orbit,
  distance: clamp(orbit.distance, whole * ZOOM.least, whole * ZOOM.most),
  elevation: clamp(orbit.elevation, LOWEST, 90),
})

/** Metres that a pixel is wide, where it is looked at. */
export const pixel = ({ distance }: Orbit, { height }: Size): number => (2 * SLOPE * distance) / Math.max(1, height)

/** The orbit on a side from which all of a box is seen. Margins are pixels. */
export function fit(box: Cuboid, { width, height }: Size, [beside, above]: Margins, side: Pick<Orbit, 'azimuth' | 'elevation'>): Orbit {
  const [right, up, back] = basis(side)
  let target = times(plus(box.min, box.max), 0.5)
  let distance = 1
  const across = (SLOPE * Math.max(40, width - 2 * beside)) / height
  const upwards = (SLOPE * Math.max(40, height - 2 * above)) / height
  // Perspective makes the near side larger: what is seen is centred again.
  for (let pass = 0; pass < 3; pass += 1) {
    distance = 0.01
    let [low, high, left, far] = [Infinity, -Infinity, Infinity, -Infinity]
    const seen = corners(box).map((corner) => minus(corner, target))
    for (const at of seen)
      distance = Math.max(distance, dot(at, back) + Math.abs(dot(at, right)) / across, dot(at, back) + Math.abs(dot(at, up)) / upwards)
    for (const at of seen) {
      const depth = distance - dot(at, back)
      ;[low, high] = [Math.min(low, dot(at, up) / depth), Math.max(high, dot(at, up) / depth)]
      ;[left, far] = [Math.min(left, dot(at, right) / depth), Math.max(far, dot(at, right) / depth)]
    }
    target = along(along(target, up, ((low + high) / 2) * distance), right, ((left + far) / 2) * distance)
  }
  return { ...side, target, distance }
}

const corners = ({ min, max }: Cuboid): Point3[] =>
  Array.from({ length: 8 }, (_, at): Point3 => [at & 1 ? max[0] : min[0], at & 2 ? max[1] : min[1], at & 4 ? max[2] : min[2]])

export function turned(orbit: Orbit, azimuth: number, elevation: number): Orbit {
  return { ...orbit, azimuth: orbit.azimuth + azimuth, elevation: clamp(orbit.elevation + elevation, LOWEST, 90) }
}

/** What is looked at goes with the hand. */
export function shifted(orbit: Orbit, size: Size, dx: number, dy: number): Orbit {
  const [right, up] = basis(orbit)
  const each = pixel(orbit, size)
  return { ...orbit, target: along(along(orbit.target, right, -dx * each), up, dy * each) }
}

/** Nearer, so that what is under `at` stays about there. `whole` is the distance from which all is seen. */
export function zoomed(orbit: Orbit, size: Size, by: number, at: readonly [number, number], whole: number): Orbit {
  const distance = clamp(orbit.distance / by, whole * ZOOM.least, whole * ZOOM.most)
  const share = 1 - distance / orbit.distance
  const nearer = shifted(orbit, size, -(at[0] - size.width / 2) * share, -(at[1] - size.height / 2) * share)
  return { ...nearer, distance }
}

/** On the way from one orbit to another, the short way round. */
export function between(from: Orbit, to: Orbit, share: number): Orbit {
  const mix = (a: number, b: number): number => a + (b - a) * share
  const turn = ((((to.azimuth - from.azimuth + 180) % 360) + 360) % 360) - 180
  return {
    target: [mix(from.target[0], to.target[0]), mix(from.target[1], to.target[1]), mix(from.target[2], to.target[2])],
    distance: mix(from.distance, to.distance),
    azimuth: from.azimuth + turn * share,
    elevation: mix(from.elevation, to.elevation),
  }
}
