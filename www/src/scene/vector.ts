/* Points and directions in space. */
import type { Point3 } from 'forage-lab'

export type Vector = Readonly<Point3>

const DEGREE = Math.PI / 180
export const radians = (degrees: number): number => degrees * DEGREE

export const plus = (a: Vector, b: Vector): Point3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
export const minus = (a: Vector, b: Vector): Point3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
export const times = (a: Vector, by: number): Point3 => [a[0] * by, a[1] * by, a[2] * by]
/** From a point so far along a direction. */
export const along = (from: Vector, direction: Vector, far: number): Point3 => plus(from, times(direction, far))
export const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
export const cross = (a: Vector, b: Vector): Point3 => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
export const lengthOf = (a: Vector): number => Math.hypot(...a)
export const clamp = (value: number, least: number, most: number): number => Math.min(most, Math.max(least, value))
