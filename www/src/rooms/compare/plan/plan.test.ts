import type { Planner, Scene } from 'forage-lab'
import { expect, test } from 'vitest'
import { type Entrant, freeSlot, keyOf, labels, paramsOf, type Plan } from './plan'

const parameter = (name: string, more: object = {}) => ({ name, kinds: [], default: 1, defaults: {}, ...more })
const pso = {
  name: 'pso',
  title: 'PSO: particle swarm',
  kinds: ['discs'],
  parameters: [
    parameter('w'),
    parameter('population'),
    parameter('iterations'),
    parameter('depth', { when: { parameter: 'w', value: '2' } }),
  ],
} as unknown as Planner
const scene = { kind: 'discs', name: 'a' } as Scene
const entrant = (params: Entrant['params'], slot = 0): Entrant => ({ slot, planner: 'pso', params })
const plan = (...entrants: Entrant[]): Plan => ({ scene, maps: null, entrants, from: 1, count: 5, budget: 'own' })

test('runs have the same key exactly if the core runs the same', () => {
  const key = (params: Entrant['params'], of: Plan = plan()): string => keyOf(pso, paramsOf(pso, entrant(params), of), of, null)
  expect(key({ w: 3, population: 9 })).toBe(key({ population: 9, w: 3 }))
  expect(key({ w: 1 }), 'a default').toBe(key({}))
  expect(key({ depth: 7 }), 'without effect').toBe(key({}))
  expect(key({ w: 2, depth: 7 })).not.toBe(key({ w: 2 }))
  expect(key({}, { ...plan(), scene: { ...scene } }), 'an equal scene').toBe(key({}))
  expect(key({}, { ...plan(), scene: { ...scene, name: 'b' } })).not.toBe(key({}))
  const maps = (columns: number): Plan => ({ ...plan(), maps: { generator: 'maze', params: { columns } } })
  expect(key({}, maps(9)), 'other maps').not.toBe(key({}, maps(8)))
  expect(key({}, { ...maps(9), scene: { ...scene, name: 'b' } }), 'whichever map is seen').toBe(key({}, maps(9)))
})

test('entrants with the same planner are named by the parameters in which they differ', () => {
  expect(labels(plan(entrant({ w: 3 })), [pso])).toEqual(['PSO'])
  expect(labels(plan(entrant({ w: 3, population: 5 }), entrant({ population: 5 })), [pso])).toEqual(['PSO, w = 3', 'PSO, w = 1'])
})

test('a new entrant takes the first free colour', () => {
  expect(freeSlot([entrant({}, 0), entrant({}, 2)])).toBe(1)
  expect(freeSlot([])).toBe(0)
})
