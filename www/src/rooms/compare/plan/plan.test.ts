import type { Planner, Scene } from 'forage-lab'
import { expect, test } from 'vitest'
import { allOf, type Entrant, freeSlot, iterationsFor, keyOf, labels, paramsOf, type Plan } from './plan'

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
  const key = (params: Entrant['params'], of: Plan = plan()): string => keyOf(pso, paramsOf(pso, entrant(params), of, null), of, null)
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

test('a budget gives iterations to entrants without their own', () => {
  expect(paramsOf(pso, entrant({ w: 3 }), plan(), 40)).toEqual({ iterations: 40, w: 3 })
  expect(paramsOf(pso, entrant({ iterations: 70 }), plan(), 40)).toEqual({ iterations: 70 })
  const spending = { start: 30, idle: 0, step: 30, limit: 200 }
  expect(allOf(spending)).toBe(6030)
  // A budget that ends within an iteration is spent by it; no run is without one.
  expect([6030, 6031, 30, 1].map((budget) => iterationsFor(spending, budget))).toEqual([200, 201, 1, 1])
  // Steps that evaluate nothing come before.
  expect([allOf({ ...spending, idle: 5 }), iterationsFor({ ...spending, idle: 5 }, 60)]).toEqual([5880, 6])
})

test('entrants with the same planner are named by the parameters in which they differ', () => {
  expect(labels(plan(entrant({ w: 3 })), [pso])).toEqual(['PSO'])
  expect(labels(plan(entrant({ w: 3, population: 5 }), entrant({ population: 5 })), [pso])).toEqual(['PSO, w = 3', 'PSO, w = 1'])
})

test('a new entrant takes the first free colour', () => {
  expect(freeSlot([entrant({}, 0), entrant({}, 2)])).toBe(1)
  expect(freeSlot([])).toBe(0)
})
