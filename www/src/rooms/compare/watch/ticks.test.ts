import { expect, test } from 'vitest'
import { foreseen, onwards } from './ticks'

test('the next time is one at which a racer moves; a finished racer does not delay it', () => {
  expect(
    onwards(0, 50, [
      { evaluations: 0, over: false },
      { evaluations: 150, over: false },
    ]),
  ).toBe(50)
  expect(
    onwards(0, 50, [
      { evaluations: 150, over: false },
      { evaluations: 170, over: false },
    ]),
  ).toBe(200)
  expect(
    onwards(100, 50, [
      { evaluations: 20, over: true },
      { evaluations: 149, over: false },
    ]),
  ).toBe(150)
  expect(onwards(100, 50, [{ evaluations: 20, over: true }])).toBe(100)
  expect(foreseen({ iteration: 10, evaluations: 1650, extent: 500, most: 150, ended: false, tail: false }, 150)).toBe(75_150)
  expect(foreseen({ iteration: 52, evaluations: 52, extent: 20_000, most: 1, ended: true, tail: false }, 0)).toBe(52)
  expect(foreseen({ iteration: 492, evaluations: 3000, extent: 492, most: 30, ended: true, tail: true }, 0)).toBe(3001)
})
