// Random search: the simplest planner. A good planner must find better solutions than this one.
import { register } from 'forage-lab'

register({
  name: 'my-random-search',
  title: 'Random search',
  summary: 'Tries random positions and keeps the best.',
  kinds: ['function'],
  layers: [
    { name: 'particles', title: 'Tried', help: 'The position tried last.' },
    { name: 'best', title: 'Best', help: 'The best so far.' },
  ],

  // The state before the first step. All that the planner knows is in the state.
  start({ box, evaluate, random }) {
    const tried = box.low.map((low, k) => low + (box.high[k] - low) * random())
    return { tried, position: tried, cost: evaluate(tried) }
  },

  // One step: from a state to the next.
  advance(state, { box, evaluate, random }) {
    const tried = box.low.map((low, k) => low + (box.high[k] - low) * random())
    const cost = evaluate(tried)
    return cost < state.cost ? { tried, position: tried, cost } : { ...state, tried }
  },

  // The best solution so far.
  best: ({ cost, position }) => ({ cost, position }),

  // What is drawn.
  draw({ tried, position }, pen) {
    pen.points('particles', [tried])
    pen.points('best', [position])
  },
})
