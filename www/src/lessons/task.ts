import type { Outcome, Scene } from 'forage-lab'
import type { Task } from './format'

/** How a run stands by a task. Whether it is really reached, and by a run that is as it says, `forage grade` decides. */
export interface Standing {
  /** It is of the task's planner, scene and parameters. */
  fits: boolean
  /** The gap, length or cost; null: there is no feasible result yet. */
  value: number | null
  evaluations: number
  /** It has not spent more than it may. */
  within: boolean
  reached: boolean
}

interface Shown {
  planner: string
  /** Somebody wrote the planner. */
  own: boolean
  scene: Scene | null
  outcome: Pick<Outcome, 'gap' | 'length' | 'cost' | 'feasible' | 'evaluations' | 'parameters'> | null
}

export function standingOf({ goal, budget, planner, own, scene, params }: Task, shown: Shown): Standing {
  const name = typeof scene === 'object' ? (scene as { name?: string }).name : scene
  const { outcome } = shown
  const given = Object.entries(params ?? {}).every(([parameter, value]) => outcome === null || outcome.parameters[parameter] === value)
  const fits =
    (planner === undefined || planner === shown.planner) &&
    (own !== true || shown.own) &&
    (name === undefined || name === shown.scene?.name) &&
    given
  const [of, most] = Object.entries(goal)[0] as ['gap' | 'length' | 'cost', number]
  const value = outcome?.feasible ? outcome[of] : null
  const evaluations = outcome?.evaluations ?? 0
  const within = budget === undefined || evaluations <= budget.evaluations
  return { fits, value, evaluations, within, reached: value !== null && value <= most }
}

export const isMet = ({ fits, within, reached }: Standing): boolean => fits && within && reached
