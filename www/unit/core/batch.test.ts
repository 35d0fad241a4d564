import { expect, test } from 'vitest'
import { bands, catalogue, compare, Trial } from '../../../pkg/node.js'
import { canRun } from '../../src/catalogue/suitability'
import { trialOf } from '../../tests/support/core'

test('bands end in the quartiles of the table', () => {
  const runs = Array.from({ length: 9 }, (_, k) => trialOf({ planner: 'cpso', scene: 'wcpso-discs', seed: k + 1 }))
  const ends = runs.map(({ record }) => record.evaluations)
  const curves = runs.map(({ curve: { evaluations, values } }) => ({
    evaluations: Float64Array.from(evaluations),
    values: Float64Array.from(values),
  }))
  const { evaluations, groups } = bands([curves], [Math.max(...ends)])
  expect(evaluations.length).toBeGreaterThan(200)
  const summary = compare([{ name: 'a', values: runs.map(({ record }) => record.value) }]).groups[0]?.summary
  expect(groups[0]?.lower.at(-1)).toBeCloseTo(summary?.lower ?? NaN, 10)
  expect(groups[0]?.median.at(-1)).toBeCloseTo(summary?.median ?? NaN, 10)
  expect(groups[0]?.upper.at(-1)).toBeCloseTo(summary?.upper ?? NaN, 10)
})

test('what is deterministic is compared, and takes no part in tests', () => {
  const values = [3, 1, 2, 5, 4]
  const groups = [
    { name: 'a', values },
    { name: 'b', values: [1, 1, 1, 1, 1], deterministic: true },
    { name: 'c', values: values.map((value) => value + 10) },
  ]
  const { pairs, friedman } = compare(groups)
  const [alone] = compare([groups[0], groups[2]].flatMap((group) => group ?? [])).pairs
  expect(pairs.map(({ first, second, p }) => [first, second, p === null])).toEqual([
    [0, 1, true],
    [0, 2, false],
    [1, 2, true],
  ])
  expect(pairs[1]).toEqual({ ...alone, first: 0, second: 2 })
  expect(pairs[0]?.better).toBe(0.1)
  expect(friedman?.ranks).toEqual([1, null, 2])
})

test('rounding errors of equal paths do not decide a test', () => {
  // Colonies that always find the shortest way: ranks of rounding errors would tell them apart.
  const groups = ['aco-wolf', 'aco-direction'].map((name) => ({
    name,
    values: Array.from({ length: 40 }, (_, k) => trialOf({ planner: name, scene: 'ant-bat-30', seed: k + 1 }).record.value),
  }))
  expect(new Set(groups.flatMap(({ values }) => values)).size).toBeGreaterThan(1)
  expect(compare(groups).pairs[0]?.p).toBe(1)
})

test('a planner is offered exactly where the core runs it', () => {
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
