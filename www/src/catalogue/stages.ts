import type { GridScene, Outcome, Planner, Stage } from 'forage-lab'
import { common } from '../locales/en/common'
import { punctuation } from '../locales/en/punctuation'
import { number } from '../text/number'

/** Where an iteration is within its part of the run. */
export interface Part {
  title: string
  /** How far it is in this part. */
  k: number
  /** How long the part is, as soon as that is known. */
  of: number | null
}

/** Nothing where a run has no parts. */
export function stageAt(stages: readonly Stage[] = [], iteration: number): Part | null {
  const at = stages.findIndex(({ end }) => iteration <= (end ?? Infinity))
  const { title, end } = stages[at] ?? {}
  if (stages.length < 2 || title === undefined) return null
  const begin = stages[at - 1]?.end ?? 0
  return { title, k: iteration - begin, of: end === undefined ? null : end - begin }
}

/** Where a run is, in words. */
export function placeOf(iteration: number, limit: number, open: boolean, part: Part | null): string {
  const { of, part: within } = common.transport
  const whole = of(number(iteration), number(limit), open)
  return part ? punctuation.clauses([whole, within(part.title, number(part.k), part.of === null ? '' : number(part.of))]) : whole
}

/** The boundary of a part that comes after an iteration, or before it. */
export function boundary(stages: readonly Stage[], iteration: number, onwards: boolean): number {
  const ends = [0, ...stages.map(({ end }) => end ?? Infinity)]
  return (onwards ? ends.find((end) => end > iteration) : ends.findLast((end) => end < iteration)) ?? iteration
}

/** What there is still to do before there can be a result: how many of the roads between the stops stand. In the end, what kept a run from one. */
export function missing(
  planner: Planner | null,
  grid: GridScene | null,
  { roads }: Readonly<Record<string, number>>,
  outcome: Outcome | null,
  finished: boolean,
): string {
  if (planner?.events.length && finished) return outcome?.trouble ?? ''
  if (!planner?.stops || roads === undefined || outcome?.order) return ''
  if (finished) return outcome?.trouble ?? ''
  const stops = grid?.stops?.length ?? 0
  return common.result.roads(number(roads), number((stops * (stops - 1)) / 2))
}
