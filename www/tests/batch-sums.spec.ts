import { expect, test } from '@playwright/test'
import { catalogue, compare, Trial } from '../../pkg/node.js'
import { digits } from '../src/batch/files'
import { bands, places, quantile, reached } from '../src/batch/summaries'
import { linear, logarithmic } from '../src/batch/chart/scale'
import { digitsFor, probability } from '../src/batch/results/words'
import type { Row } from '../src/batch/plan'
import { TestLooks } from '../src/batch/testlooks'
import { canRun } from '../src/state/able'
import { trialOf } from './support/core'

/* What the batch view makes of many runs; nothing here needs a browser. */

const curve = (...points: [number, number][]) => ({
  evaluations: Float64Array.from(points, ([at]) => at),
  values: Float64Array.from(points, ([, value]) => value),
})

test('quartiles are the core’s, whatever the number of runs', () => {
  for (let count = 1; count <= 23; count += 1) {
    const values = Array.from({ length: count }, (_, k) => Math.sin(7 * k) + k / 9)
    const summary = compare([{ name: 'a', values }]).groups[0]?.summary
    const sorted = Float64Array.from(values).sort()
    for (const [share, told] of [[0.25, summary?.lower], [0.5, summary?.median], [0.75, summary?.upper]] as const) {
      expect(quantile(sorted, share), `${share} of ${count}`).toBeCloseTo(told ?? NaN, 12)
    }
  }
})

test('a band is a step function: runs without a result yet are worst, and a quartile that falls on them is not drawn', () => {
  const runs = [curve([1, 10], [4, 5]), curve([2, 8]), curve([3, 6]), curve()]
  const { evaluations, groups } = bands([runs], [6])
  expect(evaluations).toEqual([1, 2, 3, 4, 6])
  expect(groups[0]?.median, 'two results of four are not enough for the middle').toEqual([null, null, 9, 7, 7])
  expect(groups[0]?.upper.every((value) => value === null), 'the fourth run never finds anything').toBe(true)
  expect(groups[0]?.lower[0]).toBeNull()
  expect(groups[0]?.lower[4]).toBeCloseTo(quantile([5, 6, 8, Infinity], 0.25), 12)
})

test('bands end in the quartiles of the table, however many places they have', () => {
  const runs = Array.from({ length: 9 }, (_, k) => trialOf({ planner: 'cpso', scene: 'wcpso-discs', seed: k + 1 }))
  const ends = runs.map(({ record }) => record.evaluations)
  const curves = runs.map(({ curve: { evaluations, values } }) => ({ evaluations: Float64Array.from(evaluations), values: Float64Array.from(values) }))
  const { evaluations, groups } = bands([curves], [Math.max(...ends)])
  expect(evaluations.length).toBeGreaterThan(200)
  const summary = compare([{ name: 'a', values: runs.map(({ record }) => record.value) }]).groups[0]?.summary
  expect(groups[0]?.lower.at(-1)).toBeCloseTo(summary?.lower ?? NaN, 10)
  expect(groups[0]?.median.at(-1)).toBeCloseTo(summary?.median ?? NaN, 10)
  expect(groups[0]?.upper.at(-1)).toBeCloseTo(summary?.upper ?? NaN, 10)
  // Thinned places are in order, and the ends are among them.
  const many = places([[curve(...Array.from({ length: 3000 }, (_, k): [number, number] => [k + 5, 1]))]], [3700])
  expect(many.length).toBeLessThanOrEqual(401)
  expect(many[0]).toBe(5)
  expect(many.at(-1)).toBe(3700)
  expect(many.every((at, k) => k === 0 || at > (many[k - 1] ?? 0))).toBe(true)
})

test('the same path summed up in another order is no better one', () => {
  // Colonies that always find the shortest way: ranks of rounding errors would tell them apart.
  const groups = ['aco-wolf', 'aco-direction'].map((name) => ({
    name,
    values: Array.from({ length: 40 }, (_, k) => trialOf({ planner: name, scene: 'ant-bat-30', seed: k + 1 }).record.value),
  }))
  expect(new Set(groups.flatMap(({ values }) => values)).size).toBeGreaterThan(1)
  expect(compare(groups).pairs[0]?.p).toBe(1)
})

test('a test that was seen with fewer seeds is remembered, whatever else is compared', () => {
  const looks = new TestLooks()
  const groups = (length: number, ...keys: string[]) => keys.map((key) => ({ key, lots: true, rows: Array.from({ length }, (): Row => ({}) as Row) }))
  const at = (count: number, rows: number, ...keys: string[]) => looks.at({ from: 1, count }, groups(rows, ...keys))
  expect(at(50, 20, 'a', 'b'), 'on the way').toEqual([])
  expect(at(50, 50, 'a', 'b')).toEqual([])
  expect(at(50, 50, 'a', 'b')).toEqual([])
  expect(at(100, 70, 'a', 'b')).toEqual([50])
  expect(at(100, 100, 'a', 'b')).toEqual([50])
  expect(at(150, 150, 'a', 'c')).toEqual([50, 100])
  expect(at(20, 20, 'a', 'b'), 'fewer').toEqual([])
  expect(at(100, 100, 'c', 'd'), 'others').toEqual([])
  expect(looks.at({ from: 500, count: 200 }, groups(200, 'a', 'b')), 'other seeds').toEqual([])
  expect(looks.at({ from: 1, count: 200 }, groups(200, 'a')), 'nothing is tested').toEqual([])
})

test('a planner is offered where the core runs it, and nowhere else', () => {
  const { planners, scenes } = catalogue()
  let [able, unable] = [0, 0]
  for (const planner of planners.filter(({ stops }) => stops)) {
    for (const scene of scenes.filter(({ kind }) => planner.kinds.includes(kind))) {
      const make = (): void => new Trial({ planner: planner.name, scene, seed: 1 }, undefined).free()
      if (canRun(planner, scene)) {
        expect(make, `${planner.name} on ${scene.name}`).not.toThrow()
        able += 1
      } else {
        expect(make, `${planner.name} on ${scene.name}`).toThrow()
        unable += 1
      }
    }
  }
  expect(Math.min(able, unable)).toBeGreaterThan(0)
})

test('runs that never come near the optimum keep the share below one', () => {
  expect(reached([30, null, 10, 30])).toEqual({ evaluations: [10, 30], shares: [0.25, 0.75] })
  expect(reached([null, null])).toEqual({ evaluations: [], shares: [] })
})

test('numbers in files are the shell’s', () => {
  for (const [value, text] of [
    [40, '40'], [0.1, '0.1'], [0.0001, '0.0001'], [0.00005, '5e-5'], [1.5e-9, '1.5e-9'], [-2.5e-7, '-2.5e-7'], [0, '0'], [-0, '-0'],
    [1e15, '1000000000000000'], [1e16, '1e16'], [1.25e21, '1.25e21'], [12.141590000161472, '12.141590000161472'],
  ] as const) {
    expect(digits(value)).toBe(text)
    expect(Object.is(Number(digits(value)), value)).toBe(true)
  }
})

test('an axis has room for every value, zeros on a logarithmic one too', () => {
  const values = [0, 3e-9, 2, 40]
  const log = logarithmic(values, 'value')
  for (const value of values) {
    expect(log.place(value)).toBeGreaterThanOrEqual(log.range[0])
    expect(log.place(value)).toBeLessThanOrEqual(log.range[1])
  }
  const splits = log.splits?.(20) ?? []
  expect(log.label(splits[0] ?? NaN, 1)).toBe('0')
  expect(splits.length).toBeGreaterThan(2)
  expect(splits.length).toBeLessThan(20)
  expect(log.splits?.(4).length).toBeLessThanOrEqual(5)
  // Within one decade there is no power of ten.
  expect((logarithmic([3.1, 3.4], 'value').splits?.(5) ?? []).length).toBeGreaterThan(1)
  const gaps = linear([0.001, 0.02], 'gap')
  expect(gaps.place(0.02)).toBe(2)
  expect(gaps.label(1.5, 0.5)).toBe('1.5 %')
})

test('values that lie close together keep the digits that tell them apart, and tiny probabilities are not told as zero', () => {
  expect(digitsFor([12.1459, 12.1469])).toBeGreaterThanOrEqual(8)
  expect(digitsFor([1, 100])).toBe(5)
  expect(probability(1e-40)).toBe('10⁻¹²')
  expect(probability(0.0123)).toBe('0.0123')
})
