import type { RunPart } from './format'

/** All that a run is made of. */
export type WholeRun = Required<RunPart>

/** Before the first step there is none. */
export const NO_RUN: WholeRun = { planner: '', scene: '', params: {}, seed: 1 }

/** A run with what a part says otherwise; another planner begins with its standard parameters. */
export function changed(before: WholeRun, { planner, scene, params, seed }: RunPart = {}): WholeRun {
  const other = planner !== undefined && planner !== before.planner
  return {
    planner: planner ?? before.planner,
    scene: scene ?? before.scene,
    params: params ?? (other ? {} : before.params),
    seed: seed ?? before.seed,
  }
}
