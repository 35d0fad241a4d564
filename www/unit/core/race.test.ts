import { expect, test } from 'vitest'
import { catalogue, Session, type Setup, Trial } from '../../../pkg/node.js'
import { READY } from '../../src/rooms/compare/watch/presets'

test('the feasible best of a session equals that of a trial, forward and back, whenever it is asked for', () => {
  for (const { scene, planners, seed } of READY) {
    for (const planner of planners) {
      const [session, late, trial] = [
        new Session({ planner, scene, seed } as Setup),
        new Session({ planner, scene, seed } as Setup),
        new Trial({ planner, scene, seed } as Setup, undefined),
      ]
      expect(session.curve().values.length).toBeLessThanOrEqual(1)
      session.step(500)
      session.seek(100)
      session.step(700)
      late.step(800)
      trial.step(800)
      expect(session.curve(), `${planner} on ${scene}`).toEqual(trial.curve())
      expect(late.curve(), `${planner} on ${scene}, late`).toEqual(trial.curve())
      for (const run of [session, late, trial]) run.free()
    }
  }
})

test('every ready-made race uses planners and a scene that ship', () => {
  const { planners, scenes } = catalogue()
  for (const { planners: racers, scene: name } of READY) {
    const scene = scenes.find((candidate) => candidate.name === name)
    for (const racer of racers) expect(planners.find((planner) => planner.name === racer)?.kinds, racer).toContain(scene?.kind)
    expect(racers.length).toBeLessThanOrEqual(4)
  }
})
