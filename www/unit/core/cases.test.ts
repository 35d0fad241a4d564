import { expect, test } from 'vitest'
import { catalogue, Session, type Setup } from '../../../pkg/node.js'
import { byFamily, chosen, offered } from '../../src/catalogue/cases'
import { suits } from '../../src/scene/stops'

test('each case and each preset of a planner runs as it is; every planner has one', () => {
  const known = catalogue()
  const cases = offered(known)
  expect(new Set(cases.map(({ planner }) => planner)).size).toBe(known.planners.length)
  expect(new Set(cases.map(({ name }) => name)).size).toBe(cases.length)
  for (const { planner: name, scene: place, params, seed } of cases) {
    const planner = known.planners.find((candidate) => candidate.name === name)
    const scene = known.scenes.find((candidate) => candidate.name === place)
    expect(planner && scene && suits(planner, scene)).toBe(true)
    expect(chosen(cases, known, { planner: name, scene: scene ?? null, params })).toMatchObject({ planner: name, scene: place, params })
    const session = new Session({ planner: name, scene: place, params, seed } as Setup)
    expect(session.limit).toBeGreaterThan(0)
    session.free()
  }
})

test('planners are grouped by family, none twice and none left out', () => {
  const { planners } = catalogue()
  const grouped = byFamily(planners)
  expect(
    grouped
      .flatMap(({ list }) => list)
      .map(({ name }) => name)
      .sort(),
  ).toEqual(planners.map(({ name }) => name).sort())
  expect(grouped[0]?.family).toBe('swarm')
  const other = { ...planners[0], family: 'gliders', name: 'own' } as unknown as (typeof planners)[number]
  expect(byFamily([other, ...planners]).at(-1)).toEqual({ family: 'gliders', list: [other] })
})
