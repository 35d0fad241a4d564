export type Level = 'easy' | 'medium' | 'hard'

export interface Template {
  name: string
  title: string
  level: Level
  code: string
}

const codes = import.meta.glob<string>('../../../../templates/*.js', { query: '?raw', import: 'default', eager: true })

const template = (level: Level, name: string, title: string): Template => ({
  name,
  title,
  level,
  code: codes[`../../../../templates/${name}.js`] ?? '',
})

/** From easy to hard. */
export const TEMPLATES: readonly Template[] = [
  template('easy', 'random-search', 'Random search'),
  template('easy', 'hill-climber', 'Hill climber'),
  template('medium', 'pso', 'Particle swarm: the published one'),
  template('medium', 'ants', 'Greedy ants'),
  template('hard', 'rrt', 'Random tree (RRT)'),
  template('hard', 'two-opt', '2-opt'),
]
