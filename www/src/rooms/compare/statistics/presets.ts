import type { Maps, Values } from '../../../engine/trial.protocol'

/** A batch that is ready to be run, small enough to be over in a minute. Its words are in batch.ts, by its name. */
export type Ready = {
  name: keyof typeof import('../../../locales/en/batch').batch.ready.batches
  entrants: readonly { planner: string; params?: Values }[]
  count: number
} & ({ scene: string } | { maps: Maps })

export const READY: readonly Ready[] = [
  {
    name: 'swarms',
    scene: 'wcpso-discs',
    entrants: [{ planner: 'wcpso' }, { planner: 'cpso' }, { planner: 'wpso' }, { planner: 'pso' }],
    count: 50,
  },
  {
    name: 'ants',
    scene: 'ant-bat-30',
    entrants: [{ planner: 'aco' }, { planner: 'aco-wolf' }, { planner: 'aco-direction' }, { planner: 'aco-dijkstra' }],
    count: 50,
  },
  { name: 'quantum', scene: 'qpso-10m', entrants: [{ planner: 'ltqpso' }, { planner: 'qpso' }], count: 50 },
  {
    name: 'inertia',
    scene: 'rastrigin',
    entrants: [0.4, 0.6, 0.8].map((w) => ({ planner: 'pso', params: { w } })),
    count: 50,
  },
  {
    name: 'maps',
    maps: { generator: 'rooms', params: { columns: 20, rows: 20 } },
    entrants: [
      { planner: 'aco' },
      { planner: 'aco-wolf' },
      { planner: 'aco-direction' },
      { planner: 'aco-dijkstra' },
      { planner: 'a-star' },
    ],
    count: 100,
  },
]
