import ants from '../../../../templates/ants.js?raw'
import climber from '../../../../templates/hill-climber.js?raw'
import pso from '../../../../templates/pso.js?raw'
import search from '../../../../templates/random-search.js?raw'
import rrt from '../../../../templates/rrt.js?raw'
import twoOpt from '../../../../templates/two-opt.js?raw'

export type Level = 'easy' | 'medium' | 'hard'

export interface Template {
  name: string
  title: string
  level: Level
  code: string
}

/** From easy to hard. */
export const TEMPLATES: readonly Template[] = [
  { name: 'random-search', title: 'Random search', level: 'easy', code: search },
  { name: 'hill-climber', title: 'Hill climber', level: 'easy', code: climber },
  { name: 'pso', title: 'Particle swarm: the published one', level: 'medium', code: pso },
  { name: 'ants', title: 'Greedy ants', level: 'medium', code: ants },
  { name: 'rrt', title: 'Random tree (RRT)', level: 'hard', code: rrt },
  { name: 'two-opt', title: '2-opt', level: 'hard', code: twoOpt },
]
