import type { Catalogue, Scene } from 'forage-lab'
import type { Maps, Values } from '../../../engine/trial.protocol'
import type { Budget } from './plan'

/** A comparison that is worth making. Its words are in compare.ts, by its name. */
export type Preset = {
  name: keyof typeof import('../../../locales/en/compare').compare.presets.all
  entrants: readonly { planner: string; params?: Values; scene?: Scene | undefined }[]
  /** Seeds that are over in about a minute. */
  count: number
  /** Ticks a second at which it can be followed. */
  speed: number
  /** Equal evaluations unless said otherwise. */
  budget?: Budget
} & ({ scene: string } | { maps: Maps })

const plain = (...planners: string[]): Preset['entrants'] => planners.map((planner) => ({ planner }))

const PRESETS: readonly Preset[] = [
  { name: 'swarms', scene: 'wcpso-discs', entrants: plain('pso', 'wpso', 'cpso', 'wcpso'), count: 50, speed: 30 },
  {
    name: 'inertia',
    scene: 'rastrigin',
    entrants: [0.4, 0.6, 0.8].map((w) => ({ planner: 'pso', params: { w } })),
    count: 50,
    speed: 10,
  },
  {
    name: 'bbob',
    maps: { generator: 'bbob', params: { function: 'bbob-15', dimension: 10 } },
    entrants: plain('pso', 'wcpso', 'qpso', 'ltqpso'),
    count: 15,
    speed: 10,
    budget: 10_000,
  },
  {
    name: 'shifted',
    maps: { generator: 'shifted', params: { function: 'rastrigin', dimension: 10 } },
    entrants: plain('pso', 'wcpso', 'qpso', 'ltqpso'),
    count: 30,
    speed: 10,
    budget: 10_000,
  },
  { name: 'quantum', scene: 'qpso-10m', entrants: plain('qpso', 'ltqpso'), count: 50, speed: 5 },
  { name: 'ants', scene: 'ant-bat-30', entrants: plain('aco', 'aco-wolf', 'aco-direction', 'aco-dijkstra'), count: 50, speed: 5 },
  {
    name: 'maps',
    maps: { generator: 'rooms', params: { columns: 20, rows: 20 } },
    entrants: plain('aco', 'aco-wolf', 'aco-direction', 'aco-dijkstra', 'a-star'),
    count: 100,
    speed: 5,
  },
  // Each ends when it has found what there is: nobody is stopped before.
  { name: 'exact', scene: 'ant-bat-30', entrants: plain('dijkstra', 'a-star', 'theta-star'), count: 2, speed: 60, budget: 'own' },
  { name: 'tours', scene: 'random-52', entrants: plain('bat', 'ga', 'tour-pso', 'sa'), count: 20, speed: 10, budget: 1_000_000 },
  { name: 'trees', scene: 'wcpso-discs', entrants: plain('rrt', 'rrt-connect', 'rrt-star'), count: 50, speed: 30, budget: 5000 },
  {
    name: 'arm',
    scene: 'arm-cuboid',
    entrants: plain('rrt', 'rrt-guided', 'rrt-connect', 'rrt-star'),
    count: 20,
    speed: 60,
    budget: 20_000,
  },
  {
    name: 'drives',
    scene: 'wolf-ant-20',
    entrants: plain('wolf-ant-drive', 'a-star-drive', 'd-star-lite-drive'),
    count: 20,
    speed: 10,
    budget: 'own',
  },
]

/** Those that can be run here. */
export const offered = ({ planners, scenes, generators }: Catalogue): readonly Preset[] =>
  PRESETS.filter(
    (preset) =>
      ('maps' in preset
        ? generators.some(({ name }) => name === preset.maps.generator)
        : scenes.some(({ name }) => name === preset.scene)) &&
      preset.entrants.every(({ planner }) => planners.some(({ name }) => name === planner)),
  )
