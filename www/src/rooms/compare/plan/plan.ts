import { sceneText } from '../../../text/scene-text'
import type { Generator, ParameterValue, Planner, Scene } from 'forage-lab'
import { codeOf } from '../../../catalogue/own'
import { applies, standardOn } from '../../../catalogue/parameters'
import { shortly } from '../../../catalogue/cases'
import { punctuation } from '../../../locales/en/punctuation'
import { compare as text } from '../../../locales/en/compare'
import { canRun } from '../../../catalogue/suitability'
import type { Maps, Values } from '../../../engine/trial.protocol'

/** One of those that are compared: a planner with its parameters. */
export interface Entrant {
  /** Its place among the colours, kept while it takes part. */
  slot: number
  planner: string
  /** What differs from the defaults. */
  params: Values
  /** It runs here instead of on the plan's scene: where that was edited, on what it was. */
  scene?: Scene | undefined
}

/** The plan as an entrant has it: on its own scene, if it has one. */
export const planFor = ({ scene }: Entrant, plan: Plan): Plan => (scene ? { ...plan, scene, maps: null } : plan)

/** What is run: every entrant with every seed. */
export interface Plan {
  /** With `maps` the first seed's: others are of the same kind. */
  scene: Scene
  /** Null: all seeds have the scene. */
  maps: Maps | null
  entrants: readonly Entrant[]
  from: number
  count: number
  budget: Budget
}

/** How long runs last: so many evaluations, as many as the first entrant takes by its own iterations, or each as long as its own iterations. */
export type Budget = number | 'first' | 'own'

export const MOST_ENTRANTS = 8
export const COUNT = { least: 2, most: 1000, standard: 50 }
export const MOST_BUDGET = 100_000_000
const numbers = new Map<string, number>()
const known = new WeakMap<Scene, number>()

/** A number for a scene's content. */
function numberOf(scene: Scene): number {
  const before = known.get(scene)
  if (before !== undefined) return before
  const text = JSON.stringify(scene)
  const number = numbers.get(text) ?? numbers.size
  numbers.set(text, number)
  known.set(scene, number)
  return number
}

/** What of these parameters means something on the scene. */
export function applicable(planner: Planner, scene: Scene, params: Values): Record<string, ParameterValue> {
  const meant = planner.parameters.filter((parameter) => applies(parameter, planner.parameters, scene.kind, params))
  return Object.fromEntries(
    meant.flatMap((parameter) => {
      const value = params[parameter.name]
      return value === undefined || value === standardOn(parameter, scene.kind) ? [] : [[parameter.name, value]]
    }),
  )
}

/** The parameters that an entrant runs with, as far as they differ from the defaults, by name. */
export function paramsOf(planner: Planner, { params }: Entrant, { scene }: Plan): Record<string, ParameterValue> {
  const all = applicable(planner, scene, params)
  return Object.fromEntries(Object.entries(all).sort(([a], [b]) => (a < b ? -1 : 1)))
}

/** Runs with the same key and seed are the same run, whatever plan they belong to. `evaluations`: with which they are stopped. */
export const keyOf = (planner: Planner, params: Values, { scene, maps }: Plan, evaluations: number | null): string =>
  JSON.stringify([planner.name, codeOf(planner).code, maps ?? numberOf(scene), params, evaluations])

/** A value as it is typed and as files hold it. */
export const told = (value: ParameterValue | undefined): string => String(value)

/** What is drawn on: a scene, or random maps. */
export const groundOf = ({ scene, maps }: Plan, generators: readonly Generator[]): string =>
  generators.find(({ name }) => name === maps?.generator)?.title ?? sceneText(scene.title)

/** What an entrant is called: its planner, and in which parameters it differs from others with the same planner. */
export function labels(plan: Plan, planners: readonly Planner[]): string[] {
  return plan.entrants.map((entrant) => {
    const planner = planners.find(({ name }) => name === entrant.planner)
    if (!planner) return entrant.planner
    const alike = plan.entrants.filter(({ planner: other }) => other === entrant.planner)
    const valueIn = ({ params }: Entrant, at: number): ParameterValue | undefined => {
      const parameter = planner.parameters[at]
      return parameter && (applicable(planner, plan.scene, params)[parameter.name] ?? standardOn(parameter, plan.scene.kind))
    }
    const differing = planner.parameters.flatMap(({ name }, at) => {
      const value = valueIn(entrant, at)
      return alike.some((other) => valueIn(other, at) !== value) ? [`${name} = ${told(value)}`] : []
    })
    return punctuation.clauses([shortly(planner.title), ...differing, ...(entrant.scene ? [text.entrants.before] : [])])
  })
}

/** An entrant's planner, if it runs on the scene. */
export const runnerOf = (entrant: Entrant, scene: Scene, planners: readonly Planner[]): Planner | undefined =>
  planners.find((planner) => planner.name === entrant.planner && canRun(planner, scene))

export function freeSlot(entrants: readonly Entrant[]): number {
  let slot = 0
  while (entrants.some((entrant) => entrant.slot === slot)) slot += 1
  return slot
}
