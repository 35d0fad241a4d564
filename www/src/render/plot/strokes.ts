import type { Reading } from 'forage-lab'
import type { Stroke } from './plot'

/** Readings that most planners tell have a colour of their own; the others take the next of these. */
const KNOWN: Readonly<Record<string, Stroke>> = {
  best: { token: '--best', width: 2.25 },
  length: { token: '--best', width: 2.25 },
  mean: { token: '--particle', width: 1.25 },
  free: { token: '--accent', width: 1.5, dash: [2, 3] },
}
const OTHERS: readonly Stroke[] = [
  { token: '--accent', width: 1.75 },
  { token: '--particle', width: 1.75, dash: [7, 3] },
  { token: '--best', width: 1.75, dash: [2, 3] },
  { token: '--ink-2', width: 1.25 },
  { token: '--exact', width: 1.25, dash: [9, 3, 2, 3] },
]
const LAST: Stroke = { token: '--ink-2', width: 1.25 }

/** A line for each reading: told apart by dashes and width, not by colour alone. */
export function strokes(readings: readonly Reading[]): Stroke[] {
  let next = 0
  return readings.map(({ name }) => KNOWN[name] ?? OTHERS[next++ % OTHERS.length] ?? LAST)
}
