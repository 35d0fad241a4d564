// 2-opt: reverses a segment of the tour as long as that makes it shorter. Croes 1958.
import { register } from 'forage-lab'

register({
  name: 'my-two-opt',
  title: '2-opt',
  summary: 'Reverses the segment that shortens the tour most, until none does.',
  kinds: ['tour'],
  readings: [{ name: 'length', title: 'Length', value: ({ cost }) => cost }],
  layers: [{ name: 'tour', title: 'Tour' }],

  start({ scene, evaluate, random }) {
    const order = scene.points.map((_, k) => k)
    // A random tour from the first stop.
    for (let k = order.length - 1; k > 1; k -= 1) {
      const other = 1 + Math.floor(random() * k)
      ;[order[k], order[other]] = [order[other], order[k]]
    }
    return { order, cost: evaluate(order) }
  },

  advance(state, { scene, distance, evaluate, finish }) {
    const { order } = state
    const closed = scene.closed !== false
    const n = order.length
    let best = { gain: 1e-9 }
    for (let i = 1; i < n - 1; i += 1) {
      for (let k = i + 1; k < n; k += 1) {
        const [a, b, c, d] = [order[i - 1], order[i], order[k], order[(k + 1) % n]]
        const isLast = k === n - 1 && !closed
        const gain = distance(a, b) - distance(a, c) + (isLast ? 0 : distance(c, d) - distance(b, d))
        if (gain > best.gain) best = { gain, i, k }
      }
    }
    if (best.i === undefined) return finish()
    const turned = [...order.slice(0, best.i), ...order.slice(best.i, best.k + 1).reverse(), ...order.slice(best.k + 1)]
    return { order: turned, cost: evaluate(turned) }
  },

  best: ({ order, cost }) => ({ order, cost }),
})
