import type { Catalogue } from 'forage-lab'
import type { Contender } from '../../stores/proposed.svelte'

/** A planner with the parameters that are not its defaults. */
export interface Run extends Contender {
  seed?: number
}

/** Planners on a scene that ships. */
export interface Case {
  scene: string
  runs: readonly Run[]
}

/** Whether all that a case needs is there. */
export const offered = ({ planners, scenes }: Catalogue, { scene, runs }: Case): boolean =>
  scenes.some(({ name }) => name === scene) && runs.every(({ planner }) => planners.some(({ name }) => name === planner))
