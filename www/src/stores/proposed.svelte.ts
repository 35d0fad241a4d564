import type { ParameterValue } from 'forage-lab'

/** A planner with the parameters that differ from its defaults. */
export interface Contender {
  planner: string
  params: Record<string, ParameterValue>
}

interface Proposal {
  /** A scene that ships, by its name. */
  scene: string
  planners: readonly Contender[]
}

export interface ProposedBatch extends Proposal {
  seeds: { from: number; count: number }
}

/** Two to four planners. */
export interface ProposedRace extends Proposal {
  seed: number
}

/** What one view asks another to set up: whoever opens takes it and puts null in its place. */
class Proposed {
  batch = $state.raw<ProposedBatch | null>(null)
  race = $state.raw<ProposedRace | null>(null)
}

export const proposed = new Proposed()
