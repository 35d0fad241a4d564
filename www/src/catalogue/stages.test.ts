import { expect, test } from 'vitest'
import { boundary, placeOf, stageAt } from './stages'

test('an iteration has a stage and the stage’s boundaries', () => {
  const stages = [
    { name: 'roads', title: 'Roads', end: 11 },
    { name: 'tour', title: 'Tour', end: 111 },
  ]
  expect(stageAt(stages, 0)).toEqual({ title: 'Roads', k: 0, of: 11 })
  expect(stageAt(stages, 11)).toEqual({ title: 'Roads', k: 11, of: 11 })
  expect(stageAt(stages, 12)).toEqual({ title: 'Tour', k: 1, of: 100 })
  expect(stageAt(stages.slice(1), 12)).toBeNull()
  expect(stageAt(undefined, 0)).toBeNull()
  const open = [...stages.slice(0, 1), { name: 'drive', title: 'Drive' }]
  expect(stageAt(open, 20)).toEqual({ title: 'Drive', k: 9, of: null })
  expect(boundary(open, 20, true)).toBe(Infinity)
  expect(placeOf(20, 500, true, stageAt(open, 20))).toBe('iteration 20 of at most 500, drive 9')
  expect(placeOf(12, 111, false, stageAt(stages, 12))).toBe('iteration 12 of 111, tour 1 of 100')
  expect(placeOf(7, 80, false, null)).toBe('iteration 7 of 80')
  expect([0, 5, 11, 60, 111].map((k) => boundary(stages, k, true))).toEqual([11, 11, 111, 111, 111])
  expect([0, 5, 11, 60, 111].map((k) => boundary(stages, k, false))).toEqual([0, 0, 0, 11, 11])
})
