import { codeOf, type RunSetup } from '../../../catalogue/own'
import type { Catalogue, Planner, Scene } from 'forage-lab'
import { compare as text } from '../../../locales/en/compare'
import type { Maps, Values } from '../../../engine/trial.protocol'
import { allOf, iterationsFor, type Spending } from '../../../engine/budget'
import { type Entrant, groundOf, keyOf, labels, paramsOf, type Plan, planFor, runnerOf } from './plan'

/** An entrant as it stands in the plan. */
export interface Standing {
  entrant: Entrant
  label: string
  /** Absent where it doesn't run on the scene, or is there for something else. */
  planner: Planner | undefined
  /** Where it runs. */
  scene: Scene
  maps: Maps | null
  /** With which it runs, as far as they differ from the defaults. */
  params: Values
  /** Where the budget decides how many iterations it has: as many as its first step lets expect, and the most that it could have. */
  chosen: { iterations: number; most: number } | null
  key: string
  /** Why it isn't run. */
  trouble: string
  /** How long it runs is known. */
  ready: boolean
  /** What is to be known for that. */
  spending: Asked | null
}

/** Whose spending is asked for. */
export interface Asked {
  key: string
  setup: RunSetup
}

interface Known {
  of(key: string): Spending | undefined
  refusalOf(key: string): string | undefined
}

interface Given {
  suitable: readonly Planner[]
  allowance: number | null | undefined
  spendings: Known
  refusals: Readonly<Record<string, string>>
}

function askedFor(entrant: Entrant, all: Plan, planner: Planner): Asked {
  const plan = planFor(entrant, all)
  const params = paramsOf(planner, entrant, plan)
  return {
    key: keyOf(planner, params, plan, null),
    setup: { planner: planner.name, ...codeOf(planner), scene: plan.scene, params, seed: plan.from },
  }
}

/** Evaluations at which runs of a plan are stopped; null: nowhere; undefined: it is not known yet. */
export function allowanceOf(plan: Plan, suitable: readonly Planner[], spendings: Known): number | null | undefined {
  if (typeof plan.budget === 'number') return plan.budget
  if (plan.budget === 'own') return null
  for (const entrant of plan.entrants) {
    const planner = runnerOf(entrant, planFor(entrant, plan).scene, suitable)
    const { key } = planner ? askedFor(entrant, plan, planner) : {}
    if (key === undefined || spendings.refusalOf(key) !== undefined) continue
    const spending = spendings.of(key)
    return spending && (spending.step > 0 ? allOf(spending) : null)
  }
  return null
}

export function standingsOf(
  all: Plan,
  { planners, generators }: Catalogue,
  { suitable, allowance, spendings, refusals }: Given,
): Standing[] {
  const names = labels(all, planners)
  const met = new Set<string>()
  return all.entrants.map((entrant, at): Standing => {
    const plan = planFor(entrant, all)
    const { scene, maps } = plan
    const label = names[at] ?? entrant.planner
    const planner = runnerOf(entrant, plan.scene, suitable)
    if (!planner) {
      const runs = runnerOf(entrant, plan.scene, planners) !== undefined
      const trouble = runs ? text.entrants.otherTask : text.entrants.unsuited(groundOf(plan, generators))
      return { entrant, label, planner, scene, maps, params: {}, chosen: null, key: '', trouble, ready: false, spending: null }
    }
    const spending = askedFor(entrant, plan, planner)
    const known = spendings.of(spending.key)
    const ready = allowance === null || (allowance !== undefined && known !== undefined)
    const most = planner.parameters.find(({ name }) => name === 'iterations')?.max
    const params = paramsOf(planner, entrant, plan)
    const free = allowance && known && most !== undefined && !('iterations' in params)
    const chosen = free ? { iterations: iterationsFor(known, allowance, most), most } : null
    const key = keyOf(planner, params, plan, allowance ?? null)
    const trouble = met.has(key) ? text.entrants.double : (spendings.refusalOf(spending.key) ?? refusals[key] ?? '')
    met.add(key)
    return { entrant, label, planner, scene, maps, params, chosen, key, trouble, ready, spending }
  })
}
