import type { Stage } from 'forage-lab'
import type { Span } from '../protocol'

/** What a run says of its length. */
interface Length {
  /** The iteration at which it ends at the latest. */
  readonly limit: number
  /** The last iteration, as soon as it is known. */
  readonly end?: number | undefined
}

/** The iterations that a timeline shows of a run whose end is open, at first. */
const ROOM = 100

/**
 * How many iterations a timeline shows: all of them once the end is known; before, it grows as the run goes on, and always
 * has room for the next step.
 */
export function extent({ limit, end }: Length, furthest: number): number {
  if (end !== undefined) return end
  let room = ROOM
  while (room <= furthest) room *= 2
  return Math.min(limit, room)
}

/** The length of a run that has come so far, and its parts. */
export function spanOf(session: Length & { readonly stages: Stage[] }, furthest: number): Span {
  return { end: session.end ?? null, extent: extent(session, furthest), stages: session.stages }
}
