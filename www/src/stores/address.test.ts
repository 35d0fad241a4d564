import { afterEach, expect, test } from 'vitest'
import { FakeWorker } from '../../unit/worker'
import { useHost } from '../engine/host'
import { type Address, Lab } from './lab.svelte'
import { Theme } from './theme.svelte'

let lab: Lab
afterEach(() => lab.close())

test('while a link of the address is read, the run before does not write over it', async () => {
  const worker = new FakeWorker()
  useHost(worker.host)
  const written: string[] = []
  const address: Address = { first: null, watched: true, write: (link) => written.push(link) }
  lab = new Lab(address, new Theme(), { planner: 'wcpso', scene: 'wcpso-discs', seed: 1, params: {} })
  void lab.open()
  await worker.receiveAll()
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
