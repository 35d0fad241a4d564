import type { ParameterValue, Scene } from 'forage-lab'

/** A planner with the parameters that differ from its defaults. */
export interface Contender {
  planner: string
  params: Record<string, ParameterValue>
  /** Its own, instead of the common one. */
  scene?: Scene
}

/** How a comparison is looked at: side by side, or by many runs. */
export const SIGHTS = ['watch', 'statistics'] as const
export type Sight = (typeof SIGHTS)[number]

export interface ProposedComparison {
  as: Sight
  /** A scene that ships by its name, or another. */
  scene: string | Scene
  planners: readonly Contender[]
  seeds: { from: number; count: number }
  /** A comparison of the first planner on this scene stays as it is. */
  adds?: boolean
  /** How long each runs: as long as it is set to, or until it has evaluated as often as the first. */
  budget?: 'own' | 'first'
}

/** What one room asks another to set up: the other takes it when it opens, and puts null in its place. */
class Proposed {
  comparison = $state.raw<ProposedComparison | null>(null)
}

export const proposed = new Proposed()
