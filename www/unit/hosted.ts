/* A host of a run in this thread, with the core. */
import { afterEach, beforeEach, expect, vi } from 'vitest'
import { Session, type Setup } from '../../pkg/node.js'
import { RunHost } from '../src/engine/host/run-host'
import type { Desired, FromHost, Report, Start } from '../src/engine/protocol'

export type Said<K extends FromHost['is']> = FromHost & { is: K }

export let host: RunHost
export let said: FromHost[]
export let transferred: Transferable[][]
let version: number
let returns: boolean
export let broken: unknown[]

/** Each test has a host of its own, in which nothing may break down. */
export function eachByItself(): void {
  beforeEach(() => {
    // What a host of an earlier test still says goes elsewhere.
    const [messages, travelled, errors]: [FromHost[], Transferable[][], unknown[]] = [[], [], []]
    ;[said, transferred, version, returns, broken] = [messages, travelled, 0, true, errors]
    const made = new RunHost((message, transfers = []) => {
      messages.push(message)
      travelled.push(transfers)
      if (returns && (message.is === 'report' || message.is === 'picture')) queueMicrotask(() => made.giveBack(message.frame.buffer))
    })
    made.onbroken = (error) => errors.push(error)
    host = made
  })

  afterEach(() => {
    want({ target: { play: false } })
    expect(broken).toEqual([])
  })
}

/** Whether buffers come back at once. */
export function returning(atOnce: boolean): void {
  returns = atOnce
}

/** What broke down was to. */
export function forgiven(): void {
  broken.length = 0
}

export const want = (change: Partial<Desired>): number => {
  version += 1
  host.want(version, change)
  return version
}
export const all = <K extends FromHost['is']>(is: K): Said<K>[] => said.filter((message): message is Said<K> => message.is === is)
export const reports = (): Report[] => all('report')

export const SWARM = { planner: 'wcpso', scene: 'wcpso-discs', params: {}, seed: 3 } as unknown as Start['setup']
export const DRIVE = { planner: 'a-star-drive', scene: 'patrol', params: {}, seed: 1 } as unknown as Start['setup']
export const TOURS = { planner: 'ga', scene: 'random-52', params: {}, seed: 1 } as unknown as Start['setup']
export const ANTS = { planner: 'aco', scene: 'wolf-ant-20', params: {}, seed: 1 } as unknown as Start['setup']
/** It comes to no end by itself for long. */
export const LONG = {
  planner: 'pso',
  scene: 'rastrigin',
  params: { iterations: 20_000, population: 1000 },
  seed: 1,
} as unknown as Start['setup']
export const TUNING = {
  planner: 'pso-tuning',
  scene: 'wolf-ant-20',
  params: { population: 2, iterations: 2, seeds: 1, colony_iterations: 2 },
  seed: 1,
} as unknown as Start['setup']
export const start = (setup = SWARM, at = 0, play = false): Start => ({ setup, at, play })

/** On a machine that is busy it may take long. */
export const until = <T>(check: () => T): Promise<T> => vi.waitFor(check, { timeout: 20_000, interval: 2 })

/** The report of the state in which the newest that was wanted is true. */
export const settled = (from = version): Promise<Report> =>
  until(() => {
    const report = reports().findLast((one) => one.arrived && one.version >= from)
    if (!report) throw new Error('it is still on its way')
    return report
  })

export function session<T>(setup: Start['setup'], at: number, see: (session: Session) => T): T {
  const run = new Session(setup as Setup)
  run.step(at)
  const seen = see(run)
  run.free()
  return seen
}
