import { expect, test } from 'vitest'
import { catalogue, Session, type Setup } from '../../../pkg/node.js'
import { presets } from '../../src/locales/en/presets'
import { chosen, offered, PRESETS } from '../../src/catalogue/presets'
import { suits } from '../../src/scene/stops'

test('each published case and each preset of a planner runs as it is', () => {
  const known = catalogue()
  const cases = offered(known)
  expect(cases.slice(0, PRESETS.length)).toEqual(PRESETS)
  expect(cases.length - PRESETS.length).toBe(known.planners.reduce((sum, { presets }) => sum + presets.length, 0))
  expect(PRESETS.map(({ name }) => name).sort()).toEqual(Object.keys(presets.cases).sort())
  for (const of of cases) {
    const { planner: name, scene: place, params, ...rest } = of
    const planner = known.planners.find((candidate) => candidate.name === name)
    const scene = known.scenes.find((candidate) => candidate.name === place)
    expect(planner && scene && suits(planner, scene)).toBe(true)
    expect(chosen(cases, known, { planner: name, scene: scene ?? null, params })).toBe(of)
    const session = new Session({ planner: name, scene: place, params, seed: rest.seed ?? 1 } as Setup)
    expect(session.limit).toBeGreaterThan(0)
    session.free()
  }
})
