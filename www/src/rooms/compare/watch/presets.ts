import type { Catalogue, ParameterValue } from 'forage-lab'

/** A racer before it is started. */
export interface Entry {
  planner: string
  params: Record<string, ParameterValue>
}

/** A race that is worth seeing. */
export interface Ready {
  /** Its words are in race.ts, by this name. */
  name: keyof typeof import('../../../locales/en/race').race.ready.races
  scene: string
  seed: number
  planners: readonly string[]
  /** Notches a second at which it can be followed. */
  speed: number
}

export const READY: readonly Ready[] = [
  { name: 'swarms', scene: 'wcpso-discs', seed: 1, planners: ['pso', 'wpso', 'cpso', 'wcpso'], speed: 30 },
  { name: 'quantum', scene: 'qpso-10m', seed: 1, planners: ['qpso', 'ltqpso'], speed: 5 },
  { name: 'ants', scene: 'ant-bat-30', seed: 1, planners: ['aco', 'aco-dijkstra', 'aco-direction'], speed: 5 },
  { name: 'exact', scene: 'ant-bat-30', seed: 1, planners: ['dijkstra', 'a-star', 'theta-star'], speed: 60 },
  { name: 'trees', scene: 'wcpso-discs', seed: 1, planners: ['rrt', 'rrt-connect', 'rrt-star'], speed: 30 },
  { name: 'arm', scene: 'arm-cuboid', seed: 1, planners: ['rrt', 'rrt-guided', 'rrt-connect', 'rrt-star'], speed: 60 },
  { name: 'drives', scene: 'wolf-ant-20', seed: 1, planners: ['wolf-ant-drive', 'a-star-drive', 'd-star-lite-drive'], speed: 10 },
  { name: 'tours', scene: 'random-52', seed: 1, planners: ['bat', 'ga', 'tour-pso', 'sa'], speed: 10 },
]

/** Those that can be run here. */
export const offered = ({ planners, scenes }: Catalogue): readonly Ready[] =>
  READY.filter(
    (race) =>
      scenes.some(({ name }) => name === race.scene) && race.planners.every((planner) => planners.some(({ name }) => name === planner)),
  )
