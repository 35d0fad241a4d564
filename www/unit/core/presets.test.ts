import { expect, test } from 'vitest'
import { catalogue, Session } from '../../../pkg/node.js'
import { presets } from '../../src/i18n/presets.en'
import { chosen, offered, PRESETS } from '../../src/state/presets'
import { suits } from '../../src/state/stops'

test('each published case runs as it is', () => {
  const known = catalogue()
  expect(offered(known)).toEqual(PRESETS)
  expect(PRESETS.map(({ name }) => name).sort()).toEqual(Object.keys(presets.cases).sort())
  for (const preset of PRESETS) {
    const planner = known.planners.find(({ name }) => name === preset.planner)
    const scene = known.scenes.find(({ name }) => name === preset.scene)
    expect(planner && scene && suits(planner, scene)).toBe(true)
    expect(chosen(PRESETS, known, { planner: preset.planner, scene: scene ?? null, params: preset.params })).toBe(preset)
    const session = new Session(preset)
    expect(session.limit).toBeGreaterThan(0)
    session.free()
  }
})
