// Greedy ants: each ant chooses the next stop by pheromone and nearness; the best ant of an iteration deposits pheromone.
import { register } from 'forage-lab'

register({
  name: 'my-ants',
  title: 'Greedy ants',
  summary: 'Ants choose the next stop by pheromone and nearness; the shortest tour of an iteration deposits pheromone.',
  kinds: ['tour'],
  parameters: [
    { name: 'ants', title: 'Ants', symbol: 'm', default: 20, min: 1, max: 200, integer: true },
    { name: 'alpha', title: 'Weight of pheromone', symbol: '\\alpha', default: 1, min: 0, max: 5 },
    { name: 'beta', title: 'Weight of nearness', symbol: '\\beta', default: 3, min: 0, max: 10 },
    { name: 'rho', title: 'Evaporation', symbol: '\\rho', default: 0.1, min: 0, max: 1 },
  ],
  layers: [
    { name: 'trails', title: 'Iteration best', help: 'The shortest tour of this iteration.' },
    { name: 'tour', title: 'Shortest', help: 'The shortest tour so far.' },
  ],
  formulas: [{ name: 'choice', title: 'Probability of the next stop', tex: 'p_j \\propto \\tau_{ij}^\\alpha / d_{ij}^\\beta' }],

  start({ scene, params, distance, math }) {
    const n = scene.points.length
    const nearness = new Float64Array(n * n)
    for (let i = 0; i < n; i += 1) for (let j = 0; j < n; j += 1) nearness[i * n + j] = 1 / math.pow(distance(i, j) + 1e-9, params.beta)
    return { n, nearness, pheromone: new Float64Array(n * n).fill(1), last: null, order: null, cost: null }
  },

  advance(state, { params, evaluate, random, math }) {
    // The weights are the same for all ants: they are computed once.
    const pull = state.pheromone.map((tau, k) => math.pow(tau, params.alpha) * state.nearness[k])
    let [order, cost] = [null, Infinity]
    for (let ant = 0; ant < params.ants; ant += 1) {
      const walked = walk(state.n, pull, random)
      const length = evaluate(walked)
      if (length < cost) [order, cost] = [walked, length]
    }
    for (let k = 0; k < state.pheromone.length; k += 1) state.pheromone[k] *= 1 - params.rho
    for (let k = 1; k < order.length; k += 1) {
      const [i, j] = [order[k - 1], order[k]]
      state.pheromone[i * state.n + j] += params.rho
      state.pheromone[j * state.n + i] += params.rho
    }
    state.last = order
    if (state.cost === null || cost < state.cost) Object.assign(state, { order, cost })
  },

  best: ({ order, cost }) => (order ? { order, cost } : null),

  draw({ last, order }, pen, { scene }) {
    if (!order) return
    pen.line('trails', last.map((stop) => scene.points[stop]))
    pen.line('tour', order.map((stop) => scene.points[stop]))
  },
})

/** A tour of all stops, from the first one. */
function walk(n, pull, random) {
  const order = [0]
  const left = Array.from({ length: n - 1 }, (_, k) => k + 1)
  while (left.length > 0) {
    const i = order.at(-1)
    const weights = left.map((j) => pull[i * n + j])
    let rest = random() * weights.reduce((sum, weight) => sum + weight, 0)
    let chosen = 0
    while (chosen < left.length - 1 && rest >= weights[chosen]) {
      rest -= weights[chosen]
      chosen += 1
    }
    order.push(...left.splice(chosen, 1))
  }
  return order
}
