import type { Inspection, Point } from 'forage-lab'

/** How near an answer is: as it was, nearly, or otherwise. */
export type Grade = 'right' | 'near' | 'off'

/** Of the length of a move: how far the tip of a drawn arrow may be off. */
const [RIGHT, NEAR] = [0.25, 0.6]
/** Of the likeliest step's probability: how likely another one must be. */
const [LIKELY, POSSIBLE] = [0.8, 0.3]
/** A node this much farther from the sample than the nearest is still close. */
const CLOSE = 1.25

const distance = ([ax, ay]: Point, [bx, by]: Point): number => Math.hypot(ax - bx, ay - by)

/** The first vertex of a mark. */
export function pointOf({ layers }: Inspection, role: string): Point | null {
  const vertex = layers.find((mark) => mark.role === role)?.vertices[0]
  return vertex ? [vertex[0], vertex[1]] : null
}

/** A drawn arrow against a move: how far its tip is from where the move ends, the move's length, and the angle between both in degrees. */
export interface ArrowScore {
  grade: Grade
  off: number
  length: number
  angle: number
}

export function scoreArrow(from: Point, drawn: Point, to: Point): ArrowScore {
  const [off, length] = [distance(drawn, to), distance(from, to)]
  const [turn, way] = [drawn, to].map(([x, y]) => Math.atan2(y - from[1], x - from[0])) as [number, number]
  const angle = Math.abs(((((turn - way) * 180) / Math.PI + 540) % 360) - 180)
  const share = length > 0 ? off / length : off > 0 ? Number.POSITIVE_INFINITY : 0
  return { grade: share <= RIGHT ? 'right' : share <= NEAR ? 'near' : 'off', off, length, angle }
}

/** A neighbour cell against the probabilities of all eight. */
export interface CellScore {
  grade: Grade
  /** Its probability, and that of the likeliest. */
  chosen: number
  likeliest: number
}

export function scoreCell(probabilities: readonly number[], direction: number): CellScore {
  const chosen = probabilities[direction] ?? 0
  const likeliest = Math.max(...probabilities)
  return { grade: chosen >= LIKELY * likeliest ? 'right' : chosen >= POSSIBLE * likeliest ? 'near' : 'off', chosen, likeliest }
}

/** A node against the one that grew: how far each is from the sample. */
export interface NodeScore {
  grade: Grade
  chosen: number
  nearest: number
}

export function scoreNode(sample: Point, chosen: Point, parent: Point, same: boolean): NodeScore {
  const [own, nearest] = [distance(sample, chosen), distance(sample, parent)]
  return { grade: same ? 'right' : own <= CLOSE * nearest ? 'near' : 'off', chosen: own, nearest }
}

/** A member against the one whose number is the smallest: both numbers, and how many have a smaller one than the chosen. */
export interface MemberScore {
  grade: Grade
  index: number
  value: number
  smallest: number
  before: number
}

/** Among how many of the best a chosen member must be to be nearly right. */
const AMONG = 3

export function scoreMember(values: readonly number[], index: number): MemberScore {
  const value = values[index] ?? Number.NaN
  const before = values.filter((other) => other < value).length
  return { grade: before === 0 ? 'right' : before < AMONG ? 'near' : 'off', index, value, smallest: Math.min(...values), before }
}

/** The place that is nearest to a point; -1: there is none. */
export function nearestTo(places: readonly Point[], point: Point): number {
  const distances = places.map((place) => distance(place, point))
  return distances.indexOf(Math.min(...distances))
}

/** The option whose range a value lies in; -1: none. */
export const optionAt = (options: readonly { from?: number | undefined; to?: number | undefined }[], value: number): number =>
  options.findIndex(({ from, to }) => value >= (from ?? Number.NEGATIVE_INFINITY) && value < (to ?? Number.POSITIVE_INFINITY))

/** The middle value; what is not there counts as worse than all. NaN of nothing. */
export function median(values: readonly (number | null)[]): number {
  const sorted = values.map((value) => value ?? Number.POSITIVE_INFINITY).sort((a, b) => a - b)
  const middle = sorted.length >> 1
  const [low, high] = [sorted[sorted.length - 1 - middle], sorted[middle]]
  return low === high ? (low ?? Number.NaN) : ((low ?? Number.NaN) + (high ?? Number.NaN)) / 2
}
