import { expect, test } from 'vitest'
import { allOf, iterationsFor, moreIterations } from './budget'

test('iterations are chosen so that a budget is spent', () => {
  const spending = { start: 30, idle: 0, step: 30, limit: 200 }
  expect(allOf(spending)).toBe(6030)
  // A budget that ends within an iteration is spent by it; no run is without one.
  expect([6030, 6031, 30, 1].map((budget) => iterationsFor(spending, budget, 1e6))).toEqual([200, 201, 1, 1])
  expect(iterationsFor(spending, 6031, 50), 'no more than it may have').toBe(50)
  // Steps that evaluate nothing come before.
  expect([allOf({ ...spending, idle: 5 }), iterationsFor({ ...spending, idle: 5 }, 60, 1e6)]).toEqual([5880, 6])
  expect(iterationsFor({ start: 131, idle: 341, step: 0, limit: 400 }, 100, 1e6), 'what is prepared takes more').toBe(341)
})

test('a run whose limit came before its budget was spent gets more iterations', () => {
  const over = { evaluations: 700, iteration: 7, limit: 7 }
  // 7 · 1000 / 700 · 1.1 = 11.
  expect(moreIterations(over, 7, 1000, 1e6)).toBe(11)
  expect(moreIterations({ ...over, iteration: 18, limit: 18 }, 7, 1000, 1e6), 'steps before the first iteration are no iterations').toBe(11)
  expect(moreIterations({ ...over, evaluations: 999 }, 7, 1000, 1e6), 'at least one more').toBe(8)
  expect(moreIterations({ ...over, evaluations: 0 }, 7, 1000, 1e6), 'at most 110 times as many').toBe(770)
  expect(moreIterations(over, 7, 1000, 9), 'no more than it may have').toBe(9)
  expect(moreIterations(over, 7, 700, 1e6), 'the budget is spent').toBeNull()
  expect(moreIterations({ ...over, limit: 18 }, 7, 1000, 1e6), 'it ended by itself').toBeNull()
  expect(moreIterations(over, 7, 1000, 7), 'it has the most').toBeNull()
})
