import { expect, test } from 'vitest'
import { bands, places, quantile, reached } from './summaries'

const curve = (...points: [number, number][]) => ({
  evaluations: Float64Array.from(points, ([at]) => at),
  values: Float64Array.from(points, ([, value]) => value),
})

test('a band is a step function; runs without a result count as worst, and no quartile is drawn there', () => {
  const runs = [curve([1, 10], [4, 5]), curve([2, 8]), curve([3, 6]), curve()]
  const { evaluations, groups } = bands([runs], [6])
  expect(evaluations).toEqual([1, 2, 3, 4, 6])
  expect(groups[0]?.median, 'two results of four are not enough for the middle').toEqual([null, null, 9, 7, 7])
  expect(
    groups[0]?.upper.every((value) => value === null),
    'the fourth run never finds anything',
  ).toBe(true)
  expect(groups[0]?.lower[0]).toBeNull()
  expect(groups[0]?.lower[4]).toBeCloseTo(quantile([5, 6, 8, Infinity], 0.25), 12)
})

test('a long curve is thinned to at most 401 places in order, both ends among them', () => {
  const many = places([[curve(...Array.from({ length: 3000 }, (_, k): [number, number] => [k + 5, 1]))]], [3700])
  expect(many.length).toBeLessThanOrEqual(401)
  expect(many[0]).toBe(5)
  expect(many.at(-1)).toBe(3700)
  expect(many.every((at, k) => k === 0 || at > (many[k - 1] ?? 0))).toBe(true)
})

test('runs that miss the target keep the share reached below one', () => {
  expect(reached([30, null, 10, 30])).toEqual({ evaluations: [10, 30], shares: [0.25, 0.75] })
  expect(reached([null, null])).toEqual({ evaluations: [], shares: [] })
})
