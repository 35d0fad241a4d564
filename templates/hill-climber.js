// Hill climber: takes a random step and keeps it if the cost falls. Where does it get stuck?
import { register } from 'forage-lab'

register({
  name: 'my-hill-climber',
  title: 'Hill climber',
  summary: 'Takes a random step and keeps it if the cost falls.',
  kinds: ['function'],
  parameters: [{ name: 'step', title: 'Step', symbol: 's', default: 0.05, min: 0.001, max: 1, help: 'The step size as a fraction of the box’s side.' }],
  readings: [
    { name: 'cost', title: 'Cost', symbol: 'f', value: ({ cost }) => cost },
    { name: 'kept', title: 'Steps kept', help: 'How many steps lowered the cost.', value: ({ kept }) => kept },
  ],
  layers: [
    { name: 'particles', title: 'Tried', help: 'The position tried last.' },
    { name: 'best', title: 'Climber', help: 'The current position.', pickable: true },
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

  explain: ({ cost, kept }) => ({ summary: `It stays where it is until a step lowers the cost; ${kept} steps did.`, values: { cost } }),
})
