import { expect, test } from 'vitest'
import { markAt, ranks } from './standings'

test('the best feasible value leads; of equal values the one found with fewer evaluations', () => {
  expect(ranks([{ value: 12.2, found: 300 }, null, { value: 12.1, found: 900 }, { value: 12.2, found: 150 }])).toEqual([3, null, 1, 2])
  expect(ranks([{ value: 5, found: 10 }, { value: 5 + 1e-14, found: 10 }, null])).toEqual([1, 1, null])
  const curve = { iterations: Float64Array.of(1, 7), evaluations: Float64Array.of(300, 1200), values: Float64Array.of(13, 12.5) }
  expect([0, 1, 6, 7, 99].map((iteration) => markAt(curve, iteration)?.value)).toEqual([undefined, 13, 13, 12.5, 12.5])
})
