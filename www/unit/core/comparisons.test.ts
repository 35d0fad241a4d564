import { expect, test } from 'vitest'
import { catalogue, generateScene, type GeneratorName, Session, type Setup, Trial } from '../../../pkg/node.js'
import { AGAIN, allOf, iterationsFor, moreIterations } from '../../src/engine/budget'
import { offered, type Preset } from '../../src/rooms/compare/plan/presets'

const presets = offered(catalogue())

/** The setups of a comparison's first seed. */
const setupsOf = (preset: Preset): Setup[] =>
  preset.entrants.map(({ planner, params = {} }) => {
    const scene = 'maps' in preset ? generateScene(preset.maps.generator as GeneratorName, { ...preset.maps.params }, 1) : preset.scene
    return { planner, scene, params: { ...params }, seed: 1 } as Setup
  })

test('the feasible best of a session equals that of a trial, forward and back, whenever it is asked for', () => {
  for (const preset of presets) {
    for (const setup of setupsOf(preset)) {
      const [session, late, trial] = [new Session(setup), new Session(setup), new Trial(setup, undefined)]
      expect(session.curve().values.length).toBeLessThanOrEqual(1)
      session.step(500)
      session.seek(100)
      session.step(700)
      late.step(800)
      trial.step(800)
      expect(session.curve(), `${setup.planner} in ${preset.name}`).toEqual(trial.curve())
      expect(late.curve(), `${setup.planner} in ${preset.name}, late`).toEqual(trial.curve())
      for (const run of [session, late, trial]) run.free()
    }
  }
})

test('every ready-made comparison uses planners, parameters and a scene that ship', () => {
  const { planners } = catalogue()
  // All that are listed are offered: none names what is not there.
  expect(presets.map(({ name }) => name)).toEqual([
    'swarms',
    'inertia',
    'bbob',
    'shifted',
    'quantum',
    'ants',
    'maps',
    'exact',
    'tours',
    'trees',
    'arm',
    'drives',
  ])
  for (const preset of presets) {
    for (const { planner, scene } of setupsOf(preset)) {
      const kind = (typeof scene === 'string' ? catalogue().scenes.find(({ name }) => name === scene) : scene)?.kind
      expect(planners.find(({ name }) => name === planner)?.kinds, planner).toContain(kind)
    }
    expect(preset.entrants.length).toBeLessThanOrEqual(8)
  }
})

test('with an equal budget planners end at the same evaluations, each within its last step', () => {
  for (const preset of presets.filter(({ budget = 'first' }) => budget === 'first')) {
    const spendings = setupsOf(preset).map((setup) => {
      const trial = new Trial(setup, undefined)
      const start = trial.evaluations
      while (trial.evaluations === start) trial.step(1)
      const spending = { start, idle: trial.iteration - 1, step: trial.evaluations - start, limit: trial.limit }
      trial.free()
      return spending
    })
    const budget = allOf(spendings[0] ?? { start: 0, idle: 0, step: 0, limit: 0 })
    setupsOf(preset).forEach((setup, at) => {
      const spending = spendings[at]
      if (!spending) throw new Error('no spending')
      let most = spending.start
      let enough = false
      for (
        let iterations: number | null = iterationsFor(spending, budget, 1e6), again = 0;
        iterations !== null && again <= AGAIN;
        again += 1
      ) {
        const trial = new Trial({ ...setup, params: { ...setup.params, iterations } } as Setup, undefined)
        let status: string = 'running'
        while (status === 'running' && trial.evaluations < budget) {
          const before = trial.evaluations
          status = trial.step(1)
          most = Math.max(most, trial.evaluations - before)
        }
        iterations = moreIterations(trial, iterations, budget, 1e6)
        enough = iterations === null
        expect(trial.evaluations, `${setup.planner} in ${preset.name}`).toBeLessThan(budget + Math.max(most, spending.step))
        trial.free()
      }
      expect(enough, `${setup.planner} in ${preset.name} spends the budget, or ends by itself`).toBe(true)
    })
  }
})
