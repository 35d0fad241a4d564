import { expect, test } from 'vitest'
import { catalogue, Session, type Setup, Trial } from '../../../pkg/node.js'
import { READY } from '../../src/race/ready'
import { Judge } from '../../src/worker/judge'

test('the feasible best of a racer equals that of a trial', () => {
  for (const { scene, planners, seed } of READY) {
    for (const planner of planners) {
      const [session, trial, judge] = [
        new Session({ planner, scene, seed } as Setup),
        new Trial({ planner, scene, seed } as Setup, undefined),
        new Judge(),
      ]
      judge.look(session)
      for (let step = 0; step < 800 && session.status === 'running'; step += 1) {
        session.step(1)
        judge.look(session)
      }
      trial.step(800)
      expect(judge.curve(), `${planner} on ${scene}`).toEqual(trial.curve())
      session.free()
      trial.free()
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
