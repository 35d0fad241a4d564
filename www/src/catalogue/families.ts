import type { ParameterValue } from 'forage-lab'

/** One planner of each family, at work: recorded while the page is built, and run when it is chosen. */
export interface Family {
  /** Its words are in learn.ts, by this name. */
  name: 'swarm' | 'ants' | 'bats' | 'tree' | 'moving' | 'arm'
  planner: string
  scene: string
  params: Record<string, ParameterValue>
  seed: number
  /** The last iteration that is recorded, and how many pictures there are of those up to it. */
  until: number
  pictures: number
}

export const FAMILIES: readonly Family[] = [
  { name: 'swarm', planner: 'wcpso', scene: 'wcpso-discs', params: {}, seed: 1, until: 150, pictures: 40 },
  { name: 'ants', planner: 'aco', scene: 'ant-bat-30', params: {}, seed: 1, until: 40, pictures: 40 },
  { name: 'bats', planner: 'bat', scene: 'random-52', params: { local_search: 'none' }, seed: 1, until: 100, pictures: 50 },
  { name: 'tree', planner: 'rrt-star', scene: 'wcpso-discs', params: {}, seed: 1, until: 600, pictures: 40 },
  { name: 'moving', planner: 'wolf-ant-drive', scene: 'wolf-ant-20', params: {}, seed: 23, until: 0, pictures: 60 },
  { name: 'arm', planner: 'rrt-connect', scene: 'arm-cuboid', params: {}, seed: 1, until: 0, pictures: 40 },
]
