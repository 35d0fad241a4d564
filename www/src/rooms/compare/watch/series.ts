import type { TrialCurve } from 'forage-lab'
import type { Curves } from '../../../render/plot/curves'
import type { Stroke } from '../../../render/plot/plot'
import { DASHES, tokenOf } from '../../../render/plot/statistics/strokes'

/** The line by which an entrant is known in all charts. */
export const strokeOf = (slot: number): Stroke => {
  const dash = DASHES[slot % DASHES.length]
  return { token: tokenOf(slot), width: 2.25, ...(dash && { dash }) }
}

/** The level of an exact optimum. */
export const EXACT: Stroke = { token: '--exact', width: 1.25, dash: [6, 4] }

/** The feasible bests as columns over all evaluations at which one changed, up to `end`: each holds until its next change. */
export function staircases(all: readonly (TrialCurve | null)[], end: number, lasts: readonly number[]): Curves {
  const places = new Set([0, end])
  for (const curve of all) for (const at of curve?.evaluations ?? []) if (at <= end) places.add(at)
  for (const last of lasts) if (last <= end) places.add(last)
  const iterations = [...places].sort((a, b) => a - b)
  const values = all.map((curve, racer) => {
    let next = 0
    let value: number | null = null
    return iterations.map((place) => {
      while (curve && next < curve.evaluations.length && (curve.evaluations[next] ?? Infinity) <= place)
        value = curve.values[next++] ?? null
      return place <= (lasts[racer] ?? 0) ? value : null
    })
  })
  return { iterations, values }
}
