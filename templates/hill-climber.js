// A hill climber: it takes a random step, and keeps it if it leads down. Where does it get stuck?
import { register } from 'forage-lab'

register({
  name: 'my-hill-climber',
  title: 'Hill climber',
  summary: 'Takes a random step from where it is, and stays there unless the step leads down.',
  kinds: ['function'],
  parameters: [{ name: 'step', title: 'Step', symbol: 's', default: 0.05, min: 0.001, max: 1, help: 'The size of a step: a part of the side of the box.' }],
  readings: [
    { name: 'cost', title: 'Cost', symbol: 'f', value: ({ cost }) => cost },
    { name: 'kept', title: 'Steps kept', help: 'How many steps led down.', value: ({ kept }) => kept },
  ],
  layers: [
    { name: 'particles', title: 'Tried', help: 'Where the last step led.' },
    { name: 'best', title: 'Climber', help: 'Where it is.', pickable: true },
  ],

  start({ box, evaluate, random }) {
    const position = box.low.map((low, k) => low + (box.high[k] - low) * random())
    return { position, tried: position, cost: evaluate(position), kept: 0 }
  },

  advance(state, { box, evaluate, normal, params, math }) {
    const tried = state.position.map((x, k) => {
      const step = params.step * (box.high[k] - box.low[k]) * normal()
      return math.min(box.high[k], math.max(box.low[k], x + step))
    })
    const cost = evaluate(tried)
    return cost < state.cost ? { position: tried, tried, cost, kept: state.kept + 1 } : { ...state, tried }
  },

  best: ({ cost, position }) => ({ cost, position }),

  draw({ tried, position }, pen) {
    pen.points('particles', [tried])
    pen.points('best', [position])
  },

  explain: ({ cost, kept }) => ({ summary: `It stays where it is until a step leads down; ${kept} steps did.`, values: { cost } }),
})
