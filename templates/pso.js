// Particle swarm optimisation: the planner `pso`, written in JavaScript. It finds the same positions, bit by bit.
import { register } from 'forage-lab'

register({
  name: 'my-pso',
  title: 'Particle swarm (PSO)',
  summary: 'Particles keep part of their velocity and are drawn to their personal best and the global best.',
  kinds: ['function'],
  parameters: [
    { name: 'population', title: 'Population', symbol: 'N', default: 60, min: 1, max: 1000, integer: true },
    { name: 'w', title: 'Inertia weight', symbol: '\\omega', default: 0.7298, min: 0, max: 1.5 },
    { name: 'c1', title: 'Cognitive coefficient', symbol: 'c_1', default: 1.49618, min: 0, max: 5 },
    { name: 'c2', title: 'Social coefficient', symbol: 'c_2', default: 1.49618, min: 0, max: 5 },
  ],
  layers: [
    { name: 'particles', title: 'Particles', pickable: true },
    { name: 'best', title: 'Global best' },
  ],
  formulas: [{ name: 'velocity', title: 'Velocity', tex: 'v \\leftarrow \\omega v + c_1 r_1 (p - x) + c_2 r_2 (g - x)' }],

  start({ box, evaluate, random, params }) {
    const draw = () => box.low.map((low, j) => low + (box.high[j] - low) * random())
    const positions = Array.from({ length: params.population }, draw)
    const particles = positions.map((x) => ({ x, v: x.map(() => 0), p: x, cost: evaluate(x) }))
    return { particles, g: lowest(particles) }
  },

  advance({ particles, g }, { box, evaluate, random, params: { w, c1, c2 } }) {
    for (const particle of particles) {
      particle.x = particle.x.map((x, j) => {
        const [r1, r2] = [random(), random()]
        const most = 0.2 * (box.high[j] - box.low[j])
        const v = clamp(w * particle.v[j] + c1 * r1 * (particle.p[j] - x) + c2 * r2 * (g.p[j] - x), -most, most)
        const reached = clamp(x + v, box.low[j], box.high[j])
        // It stops at the side of the box, in this coordinate.
        particle.v[j] = reached === x + v ? v : 0
        return reached
      })
    }
    for (const particle of particles) {
      const cost = evaluate(particle.x)
      if (cost < particle.cost) Object.assign(particle, { cost, p: particle.x })
    }
    return { particles, g: lowest(particles, g) }
  },

  best: ({ g }) => ({ cost: g.cost, position: g.p }),

  draw({ particles, g }, pen) {
    pen.points('particles', particles.map(({ x }) => x))
    pen.points('best', [g.p])
  },

  explain: ({ particles }, { index }) => ({ title: `Particle ${index + 1}`, summary: 'The cost of its personal best:', values: { cost: particles[index].cost } }),
})

const clamp = (x, low, high) => Math.min(high, Math.max(low, x))

/** The lowest personal best. */
function lowest(particles, known = { cost: Infinity }) {
  let best = known
  for (const { p, cost } of particles) if (cost < best.cost) best = { p, cost }
  return best
}
