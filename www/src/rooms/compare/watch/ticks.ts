import type { Furthest } from '../../../engine/protocol'

/** What the race's clock must know of a racer. */
export interface Runner {
  evaluations: number
  /** It has come to its end. */
  over: boolean
}

/** The next time at which somebody moves, a whole number of notches on. */
export function onwards(clock: number, notch: number, runners: readonly Runner[]): number {
  const waiting = runners.filter(({ over }) => !over).map(({ evaluations }) => evaluations)
  const nearest = Math.min(...waiting)
  if (!Number.isFinite(nearest)) return clock
  return nearest < clock + notch ? clock + notch : clock + notch * (Math.floor((nearest - clock) / notch) + 1)
}

/** The clock's time at which a run will be at its end, as far as can be told: many planners find an end of their own. */
export function foreseen({ iteration, evaluations, extent: limit, most, ended, tail }: Furthest, first: number): number {
  if (ended) return evaluations + Number(tail)
  const each = iteration > 0 ? (evaluations - first) / iteration : most
  return Math.max(evaluations, Math.ceil(first + each * limit))
}

/** The last of the clock's times: of the racers that go on as foreseen. */
export function extent(clock: number, ends: readonly number[]): number {
  return Math.max(clock, 1, ...ends)
}
