import type { Catalogue, ParameterValue, Planner, Scene } from 'forage-lab'
import { sameParams, sameScene } from '../scene/equality'

/** A run that shows something, or a planner's preset on the scene that goes with it. */
export interface Case {
  /** The planner's name, a dot and the case's. */
  name: string
  planner: string
  scene: string
  params: Record<string, ParameterValue>
  seed: number
  title: string
  help: string
  /** Whether `help` says what there is to see; otherwise where the parameters are from. */
  shows: boolean
}

/** The families in the order in which they are offered; those of others come after. */
const FAMILIES = ['swarm', 'ants', 'search', 'tour', 'tree', 'dynamic', 'tuning']

/** Planners by their families. */
export function byFamily(planners: readonly Planner[]): { family: string; list: Planner[] }[] {
  const families = [...new Set([...FAMILIES, ...planners.map(({ family }) => family)])]
  return families
    .map((family) => ({ family, list: planners.filter((planner) => planner.family === family) }))
    .filter(({ list }) => list.length > 0)
}

/** A planner's title is its abbreviation, a colon and what it does. */
export const shortly = (title: string): string => title.split(/[:：]/)[0] ?? title

/** Those of a planner that can be run here; a preset that a case shows is not offered again. */
export const casesOf = ({ scenes }: Catalogue, { name: planner, cases, presets }: Planner): Case[] =>
  [
    ...cases.map((one) => ({ ...one, shows: true })),
    ...presets
      .filter(({ scene, params }) => !cases.some((one) => one.scene === scene && sameParams(one.params, params)))
      .map((one) => ({ ...one, seed: 1, shows: false })),
  ]
    .filter(({ scene }) => scenes.some(({ name }) => name === scene))
    .map(({ name, ...rest }) => ({ ...rest, name: `${planner}.${name}`, planner }))

export const offered = (catalogue: Catalogue): Case[] => catalogue.planners.flatMap((planner) => casesOf(catalogue, planner))

/** The one that is set up just so, if any is. */
export function chosen(
  cases: readonly Case[],
  catalogue: Catalogue,
  setup: { planner: string; scene: Scene | null; params: Record<string, ParameterValue> },
): Case | undefined {
  return cases.find(({ planner, scene, params }) => {
    const shipped = catalogue.scenes.find(({ name }) => name === scene)
    return planner === setup.planner && shipped && sameScene(shipped, setup.scene) && sameParams(params, setup.params)
  })
}
