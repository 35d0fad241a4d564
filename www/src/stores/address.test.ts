import { afterEach, beforeEach, expect, test } from 'vitest'
import { FakeWorker } from '../../unit/worker'
import { useHost } from '../engine/host'
import { type Address, Lab } from './lab.svelte'
import { Theme } from './theme.svelte'

let [lab, worker, written] = [] as unknown as [Lab, FakeWorker, string[]]

beforeEach(async () => {
  worker = new FakeWorker()
  useHost(worker.host)
  written = []
  const address: Address = { first: null, watched: true, write: (link) => written.push(link) }
  lab = new Lab(address, new Theme(), { planner: 'wcpso', scene: 'wcpso-discs', seed: 1, params: {} })
  void lab.open()
  await worker.receiveAll()
})

afterEach(() => lab.close())

test('while a link of the address is read, the run before does not write over it', async () => {
  // Of the run that is there.
  const before = written.length
  lab.playback.seek(7)
  const opened = lab.openLink('pso,other,3,25')
  await worker.receiveAll()
  await opened
  const links = written.slice(before)
  expect(links.length).toBeGreaterThan(0)
  expect(links.filter((link) => !link.includes('pso,other'))).toEqual([])
})

test('a link that could not be loaded stays in the address while the run before goes on', async () => {
  const before = written.length
  worker.unloaded = true
  void lab.openLink('pso,other,3,25')
  await worker.receiveAll()
  lab.playback.seek(7)
  await worker.receiveAll()
  expect([worker.state.iteration, written.slice(before)]).toEqual([7, []])
  worker.unloaded = false
  void lab.notices.retry()
  await worker.receiveAll()
  expect(written.slice(before).filter((link) => !link.includes('pso,other'))).toEqual([])
  expect(written.length).toBeGreaterThan(before)
})
