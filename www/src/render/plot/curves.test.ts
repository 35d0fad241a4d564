import { expect, test } from 'vitest'
import { curves, pointAt, sample } from './curves'

test('a thinned curve keeps its first and last point', () => {
  const count = 10_001
  const long = curves(
    { columns: ['a', 'b'], iterations: Array.from({ length: count }, (_, k) => k), rows: Array.from({ length: 2 * count }, (_, at) => at) },
    ['b', 'missing'],
  )
  expect(long.iterations.length).toBeLessThan(2000)
  expect(long.iterations[0]).toBe(0)
  expect(long.iterations.at(-1)).toBe(count - 1)
  expect(long.values[0]?.at(-1)).toBe(2 * count - 1)
  expect(long.values[1]?.every((value) => value === null)).toBe(true)
  expect(long.iterations[pointAt(long, 5003)]).toBeLessThanOrEqual(5003)
  expect(long.iterations[pointAt(long, 5003) + 1]).toBeGreaterThan(5003)
  expect(sample(count, 10)).toHaveLength(10)
  expect(sample(3, 10)).toEqual([0, 1, 2])
})
