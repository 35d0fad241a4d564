import type { Stage } from 'forage-lab'

/** Where an iteration is within its part of the run. */
export interface Part {
  title: string
  /** How far it is in this part. */
  k: number
  of: number
}

/** Nothing where a run has no parts. */
export function stageAt(stages: readonly Stage[] = [], iteration: number): Part | null {
  const at = stages.findIndex(({ end }) => iteration <= end)
  const { title, end } = stages[at] ?? {}
  if (stages.length < 2 || title === undefined || end === undefined) return null
  const begin = stages[at - 1]?.end ?? 0
  return { title, k: iteration - begin, of: end - begin }
}

/** The boundary of a part that comes after an iteration, or before it. */
export function boundary(stages: readonly Stage[], iteration: number, onwards: boolean): number {
  const ends = [0, ...stages.map(({ end }) => end)]
  return (onwards ? ends.find((end) => end > iteration) : ends.findLast((end) => end < iteration)) ?? iteration
}
