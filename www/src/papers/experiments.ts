import type { Catalogue, ParameterValue } from 'forage-lab'
import type { Paper } from './row'
import type { Contender } from '../state/proposed.svelte'
import { type Preset, PRESETS } from '../state/presets'

/** A planner as it was run for a paper. */
export interface Run extends Contender {
  /** Where another run shows it better than the first. */
  seed?: number
}

/** Planners on one scene. */
export interface Case {
  /** One that ships, by its name. */
  scene: string
  runs: readonly Run[]
}

/** A table, a figure or a section of a paper. */
export interface Experiment {
  /** Its words are in papers.en.ts, by this name. */
  name: keyof typeof import('../i18n/papers.en').papers.experiments
  cases: readonly Case[]
  /** How many seeds a batch of it has; absent where a run takes too long for many in a page. */
  seeds?: number
}

type Params = Record<string, ParameterValue>

const on = (scene: string, planners: readonly string[], params: Params = {}): Case => ({
  scene,
  runs: planners.map((planner) => ({ planner, params })),
})

/** The cases of these names, which must be on one scene. */
function presets(...names: Preset['name'][]): Case {
  const runs = PRESETS.filter(({ name }) => names.includes(name))
  const [first] = runs
  if (!first || runs.length !== names.length || runs.some(({ scene }) => scene !== first.scene)) throw new Error(names.join(', '))
  return { scene: first.scene, runs }
}

const SWARMS = ['pso', 'cpso', 'wpso', 'wcpso']
const FUNCTIONS = ['matyas', 'egg-crate', 'sphere-2', 'sphere', 'rosenbrock-2', 'rosenbrock', 'ackley-2', 'ackley']
const QUANTUM = ['qpso', 'ltqpso']
const TOURS = ['bat', 'hybrid-bat', 'ga', 'tour-pso', 'sa']
const TREES = ['rrt', 'rrt-guided']
const WIDE = { step_size: 0.05 }
// Published parameters that are not the defaults.
const ANTS = { alpha: 1.5, beta: 8 }
const WOLVES = { beta: 7, rho: 0.367 }

/** What the papers tried, with their numbers of particles, ants, iterations and runs; defaults are left out. */
export const EXPERIMENTS: Readonly<Record<Paper, readonly Experiment[]>> = {
  WCPSO: [
    { name: 'functions', cases: FUNCTIONS.map((scene) => on(scene, SWARMS)), seeds: 50 },
    { name: 'discs', cases: [on('wcpso-discs', ['wpso', 'wcpso'])], seeds: 10 },
  ],
  LTQPSO: [
    { name: 'evolution', cases: ['sphere-4', 'rastrigin'].map((scene) => on(scene, QUANTUM)), seeds: 50 },
    { name: 'eight', cases: [on('qpso-10m', QUANTUM)], seeds: 50 },
    { name: 'sixteen', cases: [on('qpso-10m', QUANTUM, { segments: 16, initial: 'normal', population: 52, iterations: 99 })], seeds: 50 },
    { name: 'empty', cases: [on('qpso-10m-empty', QUANTUM)], seeds: 50 },
  ],
  ANTBAT: [
    {
      name: 'colonies',
      cases: [
        { scene: 'ant-bat-30', runs: [{ planner: 'aco', params: ANTS }, ...on('ant-bat-30', ['aco-dijkstra', 'aco-direction']).runs] },
      ],
      seeds: 30,
    },
    { name: 'tours', cases: [on('ant-bat-30', TOURS, { smooth: false })], seeds: 30 },
  ],
  'ARM-RRT': [
    {
      name: 'free',
      cases: [{ scene: 'arm-free', runs: [...on('arm-free', TREES).runs, ...on('arm-free', TREES, WIDE).runs] }],
      seeds: 100,
    },
    {
      name: 'cuboid',
      cases: [{ scene: 'arm-cuboid', runs: [...on('arm-cuboid', TREES).runs, ...on('arm-cuboid', TREES, WIDE).runs] }],
      seeds: 100,
    },
    { name: 'beside', cases: [presets('arm-star', 'arm-joints'), on('arm-puma', ['rrt-joint'])], seeds: 100 },
  ],
  'WOLF-ANT': [
    {
      name: 'wolves',
      cases: [
        {
          scene: 'wolf-ant-20',
          runs: [
            { planner: 'a-star', params: {} },
            { planner: 'aco', params: { ants: 30, ...ANTS } },
            { planner: 'aco-wolf', params: WOLVES },
          ],
        },
      ],
      seeds: 30,
    },
    { name: 'tuning', cases: [on('wolf-ant-20', ['pso-tuning'])] },
    { name: 'moving', cases: [presets('moving-ants', 'moving-a-star', 'moving-d-star-lite')], seeds: 30 },
  ],
}

/** Whether all that a case needs is there. */
export const offered = ({ planners, scenes }: Catalogue, { scene, runs }: Case): boolean =>
  scenes.some(({ name }) => name === scene) && runs.every(({ planner }) => planners.some(({ name }) => name === planner))

/** The parameters by which a run differs from the others of its case. */
export function particular({ params }: Run, { runs }: Case): [string, ParameterValue][] {
  return Object.entries(params).filter(([name, value]) => runs.some((other) => other.params[name] !== value))
}

export const RACERS = { least: 2, most: 4 } as const
