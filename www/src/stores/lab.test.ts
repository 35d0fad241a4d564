import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import { FakeWorker, passed, scene } from '../../unit/worker'
import { useHost } from '../engine/host'
import { Gone } from '../engine/run-client'
import { en } from '../locales/en/page'
import { type Address, Lab } from './lab.svelte'
import { Theme } from './theme.svelte'

/** A run that has no address. */
const FIRST = { planner: 'wcpso', scene: 'wcpso-discs', seed: 1, params: {} }
const nowhere: Address = { first: null, watched: true, write: () => undefined }

/** The page's state with a worker that answers by hand, at rest at iteration 0. */
async function opened(): Promise<{ lab: Lab; worker: FakeWorker }> {
  const worker = new FakeWorker()
  useHost(worker.host)
  const lab = new Lab(nowhere, new Theme(), FIRST)
  void lab.open()
  await worker.receiveAll()
  return { lab, worker }
}

let [lab, worker] = [] as unknown as [Lab, FakeWorker]

beforeEach(async () => {
  ;({ lab, worker } = await opened())
  expect(worker.state).toMatchObject({ planner: 'wcpso', iteration: 0, playing: false })
})

afterEach(() => lab.close())

/** The page and the worker agree in the end, and nothing is on its way any more. */
async function atRest(iteration: number): Promise<void> {
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
const CHANGES: Record<string, () => unknown> = {
  'a parameter': () => lab.parameters.set('w', 2),
  'a reset parameter': () => lab.parameters.reset('w'),
  'the planner': () => lab.setup.setPlanner('pso'),
  'the scene': () => lab.setup.openScene(scene('other')),
  'the seed': () => lab.setup.setSeed(7),
  'a random seed': () => lab.setup.newSeed(),
  'a link': () => lab.openLink('pso,other,3,0'),
  'an edit': () => lab.scene.addDisc(5, 5, 1),
}

/** After these the new run stands where the one before stood. */
const STAYING = new Set(['a parameter', 'a reset parameter', 'an edit'])

for (const [what, change] of Object.entries(CHANGES)) {
  describe(`after a change of ${what}`, () => {
    for (const received of [0, 1, 2]) {
      test(`a seek holds for the new run (${received} messages received)`, async () => {
        void change()
        for (let message = 0; message < received; message += 1) await worker.receive(false)
        lab.playback.seek(40)
        await atRest(40)
      })

      test(`of several seeks the last holds (${received} messages received)`, async () => {
        void change()
        lab.playback.seek(60)
        for (let message = 0; message < received; message += 1) await worker.receive(false)
        lab.playback.seek(50)
        lab.playback.seek(30)
        await atRest(30)
      })

      test(`steps count from where the new run begins (${received} messages received)`, async () => {
        lab.playback.seek(20)
        await worker.receiveAll()
        void change()
        for (let message = 0; message < received; message += 1) await worker.receive(false)
        for (let step = 0; step < 3; step += 1) lab.playback.stepBy(1)
        await passed()
        await atRest((STAYING.has(what) ? 20 : 0) + 3)
      })

      test(`play and pause hold for the new run (${received} messages received)`, async () => {
        void change()
        for (let message = 0; message < received; message += 1) await worker.receive(false)
        lab.playback.play()
        await worker.receiveAll()
        expect([worker.state.playing, lab.playback.playing]).toEqual([true, true])
        void change()
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
  replace().opens()
  await worker.receiveAll()
  expect(lab.selection.wanted).toEqual({ role: 'particles', index: 4 })
  lab.setup.setPlanner('pso')
  await worker.receiveAll()
  expect(lab.selection.wanted).toBeNull()
  replace().opens()
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

/** Another thread takes the place of the present one, once it `opens`. */
function replace(): { opens: () => void } {
  let opens = (): void => undefined
  worker.core = new Promise((resolve) => (opens = () => resolve(undefined)))
  lab['client']['replace']()
  worker.core = Promise.resolve(undefined)
  return { opens }
}

describe('a thread that does not answer', () => {
  test('is replaced by one that goes on as the run did', async () => {
    lab.playback.seek(20)
    lab.playback.play()
    await worker.receiveAll()
    void lab.parameters.set('w', 2)
    replace().opens()
    await worker.receiveAll()
    expect(worker.state).toMatchObject({ params: { w: 2 }, playing: true })
    expect([lab.playback.playing, lab.playback.stale]).toEqual([true, false])
  })

  test('is replaced by one that plays on from where it was', async () => {
    lab.playback.seek(20)
    lab.playback.play()
    await worker.receiveAll()
    replace().opens()
    await worker.receiveAll()
    expect(worker.state).toMatchObject({ iteration: 20, playing: true })
  })

  test('leaves seeks to the one that is loading', async () => {
    lab.playback.play()
    await worker.receiveAll()
    const { opens } = replace()
    lab.playback.seek(30)
    opens()
    await atRest(30)
  })

  test('leaves changes to the one that is loading', async () => {
    const { opens } = replace()
    lab.setup.setSeed(7)
    lab.playback.stepBy(1)
    opens()
    await atRest(1)
    expect(worker.state.seed).toBe(7)
  })

  describe('in time', () => {
    beforeEach(() => void vi.useFakeTimers({ toFake: ['setInterval', 'clearInterval'] }))
    afterEach(() => void vi.useRealTimers())

    test.each(Object.keys(CHANGES))('is replaced if it has not received %s after three seconds', async (change) => {
      const { threads } = worker
      void CHANGES[change]?.()
      vi.advanceTimersByTime(2900)
      expect(worker.threads).toBe(threads)
      vi.advanceTimersByTime(200)
      expect(worker.threads).toBe(threads + 1)
      await worker.receiveAll()
      expect(lab.playback.stale).toBe(false)
    })

    test('is not replaced while it starts a run that it was told of', async () => {
      const { threads } = worker
      lab.setup.setSeed(7)
      await worker.receive(false)
      vi.advanceTimersByTime(10_000)
      expect(worker.threads).toBe(threads)
      await atRest(0)
    })
  })

  test('leaves its questions to the next one', async () => {
    const link = lab.api.newSeed()
    replace().opens()
    await worker.receiveAll()
    expect(await link).toBeGreaterThan(1000)
  })
})

test('what a thread was asked that broke down is not asked again, and what the user made is kept', async () => {
  const asked = lab.parameters.set('w', 2)
  const question = lab.api.newSeed()
  worker.crash('unreachable')
  await asked
  await expect(question).rejects.toBeInstanceOf(Gone)
  expect([lab.phase, lab.playback.stale, lab.playback.playing]).toEqual(['crashed', true, false])
  void lab.open()
  await atRest(0)
  expect([worker.state.params, lab.parameters.values]).toEqual([{ w: 2 }, { w: 2 }])
})

test('a link in the address is opened after a thread has broken down before it was read', async () => {
  const fake = new FakeWorker()
  useHost(fake.host)
  const page = new Lab({ ...nowhere, first: '#pso,other,3,25' }, new Theme(), FIRST)
  void page.open()
  while (fake.waiting < 2) await passed()
  fake.crash('no core')
  await passed()
  expect(page.phase).toBe('crashed')
  void page.open()
  await fake.receiveAll()
  expect(fake.state).toMatchObject({ planner: '#pso', seed: 3, iteration: 25 })
  page.close()
})

test('a part that cannot be loaded is no fault of the scene, and is tried again', async () => {
  worker.unloaded = true
  lab.setup.setPlanner('pso')
  await worker.receiveAll()
  expect([lab.notices.unloaded?.message, lab.run.refusal, lab.playback.stale]).toEqual([en.notices.unloaded('Failed to fetch'), null, true])
  worker.unloaded = false
  void lab.notices.retry()
  await atRest(0)
  expect([lab.notices.unloaded, worker.state.planner]).toEqual([null, 'pso'])
})

test('a link whose part cannot be loaded is opened when it is tried again', async () => {
  worker.unloaded = true
  void lab.openLink('pso,sphere,7,3')
  await worker.receiveAll()
  const message = en.notices.link(en.notices.unloaded('Failed to fetch'))
  expect([lab.notices.unloaded?.message, lab.notices.text, lab.run.failed, lab.setup.plannerName]).toEqual([message, '', false, 'wcpso'])
  worker.unloaded = false
  void lab.notices.retry()
  await atRest(3)
  expect([lab.notices.unloaded, worker.state.planner, worker.state.seed]).toEqual([null, 'pso', 7])
})
