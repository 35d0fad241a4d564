import { expect } from 'vitest'
import { useHost } from '../src/engine/host'
import { type Address, Lab } from '../src/stores/lab.svelte'
import { Theme } from '../src/stores/theme.svelte'
import { FakeWorker, scene } from './worker'

/** A run that has no address. */
export const FIRST = { planner: 'wcpso', scene: 'wcpso-discs', seed: 1, params: {} }
export const nowhere: Address = { first: null, watched: true, write: () => undefined }

/** The page's state with a worker that answers by hand, at rest at iteration 0. */
export async function opened(): Promise<{ lab: Lab; worker: FakeWorker }> {
  const worker = new FakeWorker()
  useHost(worker.host)
  const lab = new Lab(nowhere, new Theme(), FIRST)
  void lab.open()
  await worker.receiveAll()
  return { lab, worker }
}

/** The page and the worker agree in the end, and nothing is on its way any more. */
export async function isAtRest(lab: Lab, worker: FakeWorker, iteration: number): Promise<void> {
  await worker.receiveAll()
  expect(worker.state).toMatchObject({ iteration, playing: false })
  expect({
    iteration: lab.playback.iteration,
    playing: lab.playback.playing,
    target: lab.playback.target,
    stale: lab.playback.stale,
  }).toEqual({
    iteration,
    playing: false,
    target: null,
    stale: false,
  })
  expect(lab.playback.hash).toBe(`${worker.state.planner} ${iteration}`)
}

/** Changes that restart the run, and how many of their messages the worker takes in before the user goes on. */
export const CHANGES: Record<string, (lab: Lab) => unknown> = {
  'a parameter': (lab) => lab.parameters.set('w', 2),
  'a reset parameter': (lab) => lab.parameters.reset('w'),
  'the planner': (lab) => lab.setup.setPlanner('pso'),
  'the scene': (lab) => lab.setup.openScene(scene('other')),
  'the seed': (lab) => lab.setup.setSeed(7),
  'a random seed': (lab) => lab.setup.newSeed(),
  'a link': (lab) => lab.openLink('pso,other,3,0'),
  'an edit': (lab) => lab.scene.addDisc(5, 5, 1),
}

/** Another thread takes the place of the present one, once it `opens`. */
export function replaced(lab: Lab, worker: FakeWorker): { opens: () => void } {
  let opens = (): void => undefined
  worker.core = new Promise((resolve) => (opens = () => resolve(undefined)))
  lab['client']['replace']()
  worker.core = Promise.resolve(undefined)
  return { opens }
}
