import { afterEach, beforeEach, describe, expect, test } from 'vitest'
import { CHANGES, isAtRest, opened, replaced } from '../../unit/lab'
import { type FakeWorker, passed, scene } from '../../unit/worker'
import type { Lab } from './lab.svelte'

let [lab, worker] = [] as unknown as [Lab, FakeWorker]

beforeEach(async () => {
  ;({ lab, worker } = await opened())
  expect(worker.state).toMatchObject({ planner: 'wcpso', iteration: 0, playing: false })
})

afterEach(() => lab.close())

const atRest = (iteration: number): Promise<void> => isAtRest(lab, worker, iteration)

/** After these the new run stands where the one before stood. */
const STAYING = new Set(['a parameter', 'a reset parameter', 'an edit'])

for (const [what, change] of Object.entries(CHANGES)) {
  describe(`after a change of ${what}`, () => {
    for (const received of [0, 1, 2]) {
      test(`a seek holds for the new run (${received} messages received)`, async () => {
        void change(lab)
        for (let message = 0; message < received; message += 1) await worker.receive(false)
        lab.playback.seek(40)
        await atRest(40)
      })

      test(`of several seeks the last holds (${received} messages received)`, async () => {
        void change(lab)
        lab.playback.seek(60)
        for (let message = 0; message < received; message += 1) await worker.receive(false)
        lab.playback.seek(50)
        lab.playback.seek(30)
        await atRest(30)
      })

      test(`steps count from where the new run begins (${received} messages received)`, async () => {
        lab.playback.seek(20)
        await worker.receiveAll()
        void change(lab)
        for (let message = 0; message < received; message += 1) await worker.receive(false)
        for (let step = 0; step < 3; step += 1) lab.playback.stepBy(1)
        await passed()
        await atRest((STAYING.has(what) ? 20 : 0) + 3)
      })

      test(`play and pause hold for the new run (${received} messages received)`, async () => {
        void change(lab)
        for (let message = 0; message < received; message += 1) await worker.receive(false)
        lab.playback.play()
        await worker.receiveAll()
        expect([worker.state.playing, lab.playback.playing]).toEqual([true, true])
        void change(lab)
        for (let message = 0; message < received; message += 1) await worker.receive(false)
        lab.playback.pause()
        await atRest(0)
      })
    }
  })
}

test('a seek between two changes holds for the later run, too: it stands where the one before was to stand', async () => {
  void lab.parameters.set('w', 2)
  lab.playback.seek(40)
  void lab.parameters.set('c', 3)
  await atRest(40)
  expect(worker.state.params).toEqual({ w: 2, c: 3 })
})

test('a change leaves a run that can be gone back to, where it stood, and forward again', async () => {
  lab.playback.seek(20)
  await atRest(20)
  void lab.parameters.set('w', 2)
  await atRest(20)
  expect(lab.experiments.shown?.setup.params).toEqual({})
  lab.playback.seek(33)
  await atRest(33)
  lab.scene.addDisc(5, 5, 1)
  await atRest(33)
  const edited = lab.scene.present
  lab.undo()
  await atRest(33)
  expect([lab.parameters.values, lab.scene.present === edited]).toEqual([{ w: 2 }, false])
  expect(lab.experiments.shown?.setup.scene, 'what was undone is what it is compared with').toBe(edited)
  lab.undo()
  await atRest(20)
  expect([lab.parameters.values, lab.experiments.canUndo]).toEqual([{}, false])
  lab.redo()
  await atRest(33)
  lab.redo()
  await atRest(33)
  expect([lab.scene.present === edited, lab.parameters.values, lab.experiments.canRedo]).toEqual([true, { w: 2 }, false])
})

test('what is refused, or let go of, is no step', async () => {
  lab.playback.seek(20)
  await atRest(20)
  void lab.parameters.set('w', 2)
  await atRest(20)
  lab.undo()
  await atRest(20)
  void lab.parameters.set('w', -1)
  await worker.receiveAll()
  expect(lab.parameters.values).toEqual({})
  // Nor is what is let go of: what was undone can still be done again.
  if (lab.scene.discs) lab.scene.drag({ ...lab.scene.discs, discs: [] })
  lab.scene.abandon()
  await atRest(20)
  expect([lab.experiments.canUndo, lab.experiments.canRedo]).toEqual([false, true])
  lab.redo()
  await atRest(20)
  expect(lab.parameters.values).toEqual({ w: 2 })
})

test('a seek after two changes holds for the run with both', async () => {
  void lab.parameters.set('w', 2)
  void lab.parameters.set('c', 3)
  lab.playback.seek(40)
  await atRest(40)
  expect(worker.state.params).toEqual({ w: 2, c: 3 })
})

test('a seek after a value that is refused holds for the run that stays', async () => {
  void lab.parameters.set('w', -1)
  lab.playback.seek(40)
  await atRest(40)
  expect(lab.parameters.errors).toEqual({ w: 'below zero' })
})

test('the end is that of the new run', async () => {
  void lab.parameters.set('iterations', 500)
  lab.playback.seek(Infinity)
  await atRest(500)
})

test('steps that come faster than pictures all count', async () => {
  lab.playback.stepBy(1)
  await worker.receive(false)
  lab.playback.stepBy(1)
  worker.show()
  lab.playback.stepBy(1)
  await atRest(3)
})

test('a picture from before a seek does not pass for its result', async () => {
  lab.playback.seek(10)
  await worker.receive(false)
  lab.playback.seek(20)
  worker.show()
  expect({ target: lab.playback.target, hash: lab.playback.hash }).toEqual({ target: 20, hash: '' })
  await atRest(20)
})

test('a picture that overtakes the answer to its start leaves nothing on its way', async () => {
  void lab.openLink('pso,other,3,25')
  await worker.receive()
  // The picture is there at once, the answer only after it.
  await worker.receive()
  await atRest(25)
})

test('a run plays on from where a link puts it', async () => {
  void lab.openLink('pso,other,3,25')
  await worker.receive(false)
  lab.playback.play()
  await worker.receiveAll()
  expect(worker.state).toMatchObject({ iteration: 25, playing: true })
  expect(lab.playback.target).toBeNull()
})

test('the planner that is chosen after a link stays', async () => {
  void lab.openLink('wcpso,other,3,25')
  lab.setup.setPlanner('pso')
  await worker.receiveAll()
  expect(worker.state.planner).toBe('pso')
  expect(lab.setup.plannerName).toBe('pso')
})

test('a link that is opened after a parameter was set has its own parameters', async () => {
  void lab.parameters.set('w', 2)
  void lab.openLink('pso,other,3,25')
  await atRest(25)
  expect(worker.state.params).toEqual({})
})

test('the newest value of a parameter stays, also when it is the default', async () => {
  void lab.parameters.set('w', 2)
  lab.parameters.reset('w')
  await worker.receiveAll()
  expect(worker.state.params).toEqual({})
  expect(lab.parameters.values).toEqual({})
})

test('while a slider is dragged, each value is taken as its run begins', async () => {
  for (const value of [2, 3]) void lab.parameters.set('w', value)
  await worker.receive()
  expect(lab.parameters.values).toEqual({ w: 2 })
  await worker.receiveAll()
  expect(worker.state.params).toEqual({ w: 3 })
})

test('a value before one that is refused stays', async () => {
  for (const value of [2, -1]) void lab.parameters.set('w', value)
  await worker.receiveAll()
  expect([worker.state.params, lab.parameters.values]).toEqual([{ w: 2 }, { w: 2 }])
  expect(lab.parameters.errors).toEqual({ w: 'below zero' })
})

test('a seed that is typed after a random one was asked for stays', async () => {
  void lab.setup.newSeed()
  lab.setup.setSeed(7)
  await worker.receiveAll()
  expect(worker.state.seed).toBe(7)
})

test('what is picked in the old run is not inspected in the new one', async () => {
  const picked = lab.selection.pick(4, 0, 1)
  lab.setup.setPlanner('pso')
  await worker.receiveAll()
  await picked
  expect(lab.selection.wanted).toBeNull()
})

test('what is inspected while the run restarts stays inspected', async () => {
  lab.setup.setPlanner('pso')
  const picked = lab.selection.pick(4, 0, 1)
  await worker.receiveAll()
  await picked
  expect(lab.selection.wanted).toEqual({ role: 'pso', index: 4 })
})

test('what was inspected in a run is not inspected in the next, nor by a thread that takes its place', async () => {
  lab.selection.inspect({ role: 'particles', index: 4 } as never)
  await worker.receiveAll()
  replaced(lab, worker).opens()
  await worker.receiveAll()
  expect(lab.selection.wanted).toEqual({ role: 'particles', index: 4 })
  lab.setup.setPlanner('pso')
  await worker.receiveAll()
  expect(lab.selection.wanted).toBeNull()
  replaced(lab, worker).opens()
  await worker.receiveAll()
  expect(lab.selection.wanted).toBeNull()
})

describe('after a scene that is refused', () => {
  beforeEach(async () => {
    lab.playback.seek(20)
    await worker.receiveAll()
    lab.scene.addDisc(1, 1, 1)
    await worker.receiveAll()
    expect(lab.run.refusal).toMatchObject({ field: 'start' })
    // The run of before goes on.
    lab.playback.play()
    await worker.receiveAll()
    worker.advance(50)
    await worker.receiveAll()
    expect([lab.playback.iteration, lab.playback.playing]).toEqual([50, true])
  })

  test('steps count from where the run of before is', async () => {
    lab.playback.stepBy(1)
    await worker.receiveAll()
    expect([worker.state.iteration, lab.playback.iteration]).toEqual([51, 51])
  })

  test('a pause leaves the run of before where it is', async () => {
    lab.playback.pause()
    await worker.receiveAll()
    expect(worker.state).toMatchObject({ iteration: 50, playing: false })
    lab.playback.play()
    await worker.receiveAll()
    expect(worker.state).toMatchObject({ iteration: 50, playing: true })
  })
})

describe('steps that wait for a change', () => {
  test('give way to a seek that comes after them', async () => {
    void lab.parameters.set('w', 2)
    lab.playback.stepBy(1)
    lab.playback.seek(50)
    await atRest(50)
  })

  test('give way to a play that comes after them', async () => {
    void lab.parameters.set('w', 2)
    lab.playback.stepBy(1)
    lab.playback.play()
    await worker.receiveAll()
    expect([worker.state.playing, lab.playback.playing]).toEqual([true, true])
  })

  test('count from a seek that came before them', async () => {
    void lab.parameters.set('w', 2)
    lab.playback.stepBy(1)
    lab.playback.seek(50)
    lab.playback.stepBy(1)
    lab.playback.stepBy(1)
    await atRest(52)
  })
})

test('the fingerprint of a link is not compared with the run before it', async () => {
  void lab.openLink('pso,other,3,25,pso 25')
  await atRest(25)
  expect(lab.notices.text).toBe('')
  const opened = lab.openLink('wcpso,other,3,25,wcpso 25')
  await worker.receive(false)
  // A picture of the old run, asked for by something else, comes after the link was read.
  worker.repeat()
  await opened
  await atRest(25)
  expect(lab.notices.text).toBe('')
  void lab.openLink('pso,other,3,25,something else')
  await atRest(25)
  expect(lab.notices.text).not.toBe('')
})

test('a scene from a file that comes after another was opened does not replace it', async () => {
  let answered = (_: string): void => undefined
  const asked = lab.scene.ask(() => new Promise<string>((resolve) => (answered = resolve)))
  lab.setup.openScene(scene('other'))
  answered('a large map')
  expect(await asked).toBeNull()
  await worker.receiveAll()
  expect(await lab.scene.ask(() => Promise.resolve('a map'))).toBe('a map')
})
