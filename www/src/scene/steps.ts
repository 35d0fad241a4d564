import type { Point } from 'forage-lab'

/** Numbers a vertex: x, y, z, weight. */
const VERTEX = 4

export interface Ant {
  /** x and y of where it was at each step. */
  places: Float32Array
  /** The last of its steps. */
  last: number
  arrived: boolean
}

export interface Counts {
  walking: number
  arrived: number
  stuck: number
}

/** The ways of an iteration's ants, step by step. */
export class Walk {
  readonly end: number
  /** How long a straight step is. */
  readonly stride: number

  constructor(readonly ants: readonly Ant[]) {
    this.end = ants.reduce((most, { last }) => Math.max(most, last), 0)
    this.stride = ants.reduce((least, { places, last }) => (last > 0 ? Math.min(least, strideOf(places)) : least), Infinity)
  }

  /** From the lines of a layer in a frame: a vertex a step, of weight 1 where the ant arrived. */
  static of(lines: readonly Float32Array[]): Walk {
    return new Walk(
      lines
        .filter(({ length }) => length > 0)
        .map((line) => {
          const count = line.length / VERTEX
          const places = Float32Array.from({ length: 2 * count }, (_, k) => line[VERTEX * (k >> 1) + (k & 1)] ?? 0)
          return { places, last: count - 1, arrived: (line[3] ?? 0) > 0.5 }
        }),
    )
  }

  /** How many are on their way, at the goal and at a dead end after a step. */
  counts(step: number): Counts {
    const there = this.ants.filter(({ last }) => last <= step)
    const arrived = there.filter((ant) => ant.arrived).length
    return { walking: this.ants.length - there.length, arrived, stuck: there.length - arrived }
  }
}

/** Ends don't always lie in the middle of their cells: the first step may be shorter than others. */
function strideOf(places: Float32Array): number {
  const step = Math.min(1, places.length / 2 - 2)
  const along = (axis: 0 | 1): number => Math.abs((places[2 * (step + 1) + axis] ?? 0) - (places[2 * step + axis] ?? 0))
  return Math.max(along(0), along(1))
}

/** Where an ant is between its steps. */
export function placeAt({ places, last }: Ant, time: number): Point {
  const step = Math.min(Math.floor(time), last)
  const [from, to] = [2 * step, 2 * Math.min(step + 1, last)]
  const share = Math.min(time, last) - step
  const along = (axis: 0 | 1): number => (places[from + axis] ?? 0) * (1 - share) + (places[to + axis] ?? 0) * share
  return [along(0), along(1)]
}
