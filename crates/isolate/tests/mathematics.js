// Numbers that engines may compute otherwise: powers and the functions of Math, by random arguments.
import { register } from 'forage-lab'

const step = (x, y) => {
  const z = [x ** 2, Math.abs(x) ** y, y ** x ** 0.5 || 0, (x + y) ** 3, (-x) ** -1.7 || 0]
  const one = ['sin', 'cos', 'tan', 'exp', 'log', 'log10', 'sqrt', 'asin', 'acos', 'fround', 'trunc', 'round'].map((name) => Math[name](x / 9) || 0)
  const two = ['pow', 'atan2', 'hypot', 'min', 'max', 'imul'].map((name) => Math[name](x, y) || 0)
  return [...z, ...one, ...two, x % y, Math.SQRT2 * x, Math.LN10 * y].map((value) => (Number.isFinite(value) ? value : 0))
}

register({
  name: 'mathematics',
  kinds: ['function'],
  start: ({ box, evaluate, random }) => {
    const position = box.low.map((low, k) => low + (box.high[k] - low) * random())
    return { position, cost: evaluate(position), seen: [] }
  },
  advance: ({ position, cost }, { random }) => {
    const seen = []
    for (let k = 0; k < 500; k += 1) seen.push(...step(9 * random(), 9 * random()))
    return { position, cost, seen }
  },
  best: ({ position, cost }) => ({ position, cost }),
})
