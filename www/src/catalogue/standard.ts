import type { ParameterValue } from 'forage-lab'

/** A planner with the parameters that differ from its defaults, a scene that ships, and a seed. */
export interface Standard {
  planner: string
  scene: string
  seed: number
  params: Readonly<Record<string, ParameterValue>>
}

/** What is shown where nothing else is asked for: few enough particles that each can be followed. */
export const STANDARD: Standard = { planner: 'pso', scene: 'wcpso-discs', seed: 1, params: { population: 12 } }
