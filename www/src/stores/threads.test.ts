import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import { CHANGES, FIRST, isAtRest, nowhere, opened, replaced } from '../../unit/lab'
import { FakeWorker, passed } from '../../unit/worker'
import { useHost } from '../engine/host'
import { Gone } from '../engine/run-client'
import { common as en } from '../locales/en/common'
import { Lab } from './lab.svelte'
import { Theme } from './theme.svelte'

let [lab, worker] = [] as unknown as [Lab, FakeWorker]

beforeEach(async () => {
  ;({ lab, worker } = await opened())
})

afterEach(() => lab.close())

const atRest = (iteration: number): Promise<void> => isAtRest(lab, worker, iteration)

describe('a thread that does not answer', () => {
  test('is replaced by one that goes on as the run did', async () => {
    lab.playback.seek(20)
    lab.playback.play()
    await worker.receiveAll()
    void lab.parameters.set('w', 2)
    replaced(lab, worker).opens()
    await worker.receiveAll()
    expect(worker.state).toMatchObject({ params: { w: 2 }, playing: true })
    expect([lab.playback.playing, lab.playback.stale]).toEqual([true, false])
  })

  test('is replaced by one that plays on from where it was', async () => {
    lab.playback.seek(20)
    lab.playback.play()
    await worker.receiveAll()
    replaced(lab, worker).opens()
    await worker.receiveAll()
    expect(worker.state).toMatchObject({ iteration: 20, playing: true })
  })

  test('leaves seeks to the one that is loading', async () => {
    lab.playback.play()
    await worker.receiveAll()
    const { opens } = replaced(lab, worker)
    lab.playback.seek(30)
    opens()
    await atRest(30)
  })

  test('leaves changes to the one that is loading', async () => {
    const { opens } = replaced(lab, worker)
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
      void CHANGES[change]?.(lab)
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
    replaced(lab, worker).opens()
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
