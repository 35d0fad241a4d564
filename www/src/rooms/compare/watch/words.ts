import type { Outcome, Scene } from 'forage-lab'
import { compare as plan } from '../../../locales/en/compare'
import { race as text } from '../../../locales/en/race'
import { number, percent } from '../../../text/number'
import { unitOf } from '../../../text/unit'
import type { Lane } from './lane.svelte'

/* How a racer's result is told, in its lane and in the table. */

const DIGITS = 6

/** The exact optimum by the rule that a racer keeps to; a file's that was beaten is none. */
export function exactOf({ outcome, run }: Lane): number | null {
  if (outcome) return outcome.exact_by === 'refuted' ? null : outcome.exact
  return run?.exact?.length ?? null
}

/** The feasible best; without one, the best there is. */
export function bestOf({ mark, outcome }: Lane): number | null {
  return mark?.value ?? outcome?.length ?? outcome?.cost ?? null
}

/** What the feasible best is called. */
export const bestTitle = (scene: Scene | null): string => text.best(scene?.kind === 'function')

export const told = (value: number | null, scene: Scene | null): string =>
  value === null ? number(null) : number(value, DIGITS) + unitOf(scene)

/** How far the feasible best lies from the optimum, in per cent; nothing where that says nothing. */
export function gapOf(lane: Lane): string | null {
  const [exact, { mark }] = [exactOf(lane), lane]
  return mark && exact !== null && exact !== 0 ? percent((mark.value - exact) / exact, true) : null
}

/** Whose optimum a racer's gap is measured by, where others race by another: their gaps say nothing about each other. */
export function referenceOf(lane: Lane, lanes: readonly Lane[]): string | null {
  const ruleOf = (one: Lane): Exclude<Outcome['exact_by'], 'refuted'> | null => {
    const { racing, outcome } = one
    return racing && outcome && outcome.exact_by !== 'refuted' && outcome.exact !== null ? outcome.exact_by : null
  }
  const own = ruleOf(lane)
  const rules = new Set(lanes.map(ruleOf).filter((rule) => rule !== null))
  return own !== null && rules.size > 1 ? plan.references[own] : null
}

/** Whether the best may be used, in words; nothing where anything may. */
export function verdictOf({ mark, outcome }: Lane, scene: Scene | null): { said: string; good: boolean } | null {
  if (mark) return outcome && outcome.length !== null && scene?.kind !== 'tour' ? { said: text.lane.free, good: true } : null
  if (outcome && outcome.length !== null && !outcome.feasible) return { said: text.lane.cuts, good: false }
  return null
}
