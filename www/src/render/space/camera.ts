import type { Point3 } from 'forage-lab'
import { dot, lengthOf, minus, plus, times, type Vector } from '../../scene/vector'
import type { Size } from '../view'
import { basis, eyeOf, NEAR, type Orbit, SLOPE } from './orbit'

/** A point on the screen, and how far it is from the eye. */
export interface Seen {
  x: number
  y: number
  depth: number
}

/** From the eye through a point of the screen; the direction has length 1. */
export interface Ray {
  origin: Point3
  direction: Point3
}

/** How an orbit shows space on a screen of this size. */
export class Camera {
  readonly eye: Point3
  private readonly axes: ReturnType<typeof basis>
  /** Pixels a metre at a distance of one metre. */
  private readonly scale: number

  constructor(
    readonly orbit: Orbit,
    private readonly size: Size,
  ) {
    this.eye = eyeOf(orbit)
    this.axes = basis(orbit)
    this.scale = size.height / (2 * SLOPE)
  }

  /** Where a point is on the screen; null: behind the eye. */
  project(point: Vector): Seen | null {
    const [right, up, back] = this.axes
    const way = minus(point, this.eye)
    const ahead = -dot(way, back)
    if (ahead < NEAR * this.orbit.distance) return null
    const by = this.scale / ahead
    return { x: this.size.width / 2 + by * dot(way, right), y: this.size.height / 2 - by * dot(way, up), depth: lengthOf(way) }
  }

  ray([x, y]: readonly [number, number]): Ray {
    const [right, up, back] = this.axes
    const across = plus(times(right, (x - this.size.width / 2) / this.scale), times(up, (this.size.height / 2 - y) / this.scale))
    const way = minus(across, back)
    return { origin: this.eye, direction: times(way, 1 / lengthOf(way)) }
  }
}
