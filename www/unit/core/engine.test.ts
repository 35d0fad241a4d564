import { expect, test, vi } from 'vitest'
import { catalogue, Session, type Setup, type UncheckedSetup } from '../../../pkg/node.js'
import type { Host } from '../../src/engine/host'
import { RunHost } from '../../src/engine/host/run-host'
import type { Desired, FromHost, Refusal, Report, ToHost } from '../../src/engine/protocol'
import { RunClient } from '../../src/engine/run-client'

/** A thread in this one: messages are copied and arrive later, in their order. */
class LocalWorker {
  onmessage: ((event: { data: FromHost }) => void) | null = null
  onerror: unknown = null
  private ended = false
  private readonly host = new RunHost((message) => this.deliver(structuredClone(message)))

  constructor() {
    this.host.onbroken = (error) => {
      throw error
    }
  }

  private deliver(message: FromHost): void {
    setImmediate(() => {
      if (!this.ended) this.onmessage?.({ data: message })
    })
  }

  postMessage(sent: ToHost): void {
    const message = structuredClone(sent)
    setImmediate(() => {
      if (this.ended) return
      this.deliver({ is: 'seen', number: message.number })
      if (message.is === 'open') this.deliver({ is: 'open' })
      if (message.is === 'want') this.host.want(message.version, message.change)
      if (message.is === 'buffer') this.host.giveBack(message.buffer)
      if (message.is === 'results') this.host.provide(message.id, message.results)
    })
  }

  terminate(): void {
    this.ended = true
    this.host.want(Number.MAX_SAFE_INTEGER, { target: { play: false } })
  }
}

const local: Host = {
  worker: () => new LocalWorker() as unknown as Worker,
  core: () => Promise.resolve(undefined),
  catalogue: () => Promise.reject(new Error('nobody asks for it')),
}

/** Numbers between 0 and 1 that are the same each time (mulberry32). */
function lots(seed: number): () => number {
  let state = seed
  return () => {
    state = (state + 0x6d2b79f5) | 0
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state)
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32
  }
}

const SETUPS = [
  { planner: 'wcpso', scene: 'wcpso-discs' },
  { planner: 'pso', scene: 'wcpso-discs' },
  { planner: 'qpso', scene: 'sphere' },
  { planner: 'aco', scene: 'wolf-ant-20' },
  { planner: 'a-star', scene: 'wolf-ant-20' },
  { planner: 'rrt', scene: 'wcpso-discs' },
  { planner: 'sa', scene: 'random-52' },
].map((setup) => ({ ...setup, params: {}, seed: 1 }))
/** Of another kind of scene, and no number of particles. */
const REFUSED: UncheckedSetup[] = [
  { planner: 'aco', scene: 'sphere', params: {}, seed: 1 },
  { planner: 'pso', scene: 'wcpso-discs', params: { population: 0 }, seed: 1 },
]

interface Subject {
  client: RunClient
  /** What it reported last. */
  last(): Report | null
  refusals: Refusal[]
}

function client(wanted: Partial<Desired> = {}): Subject {
  let last: Report | null = null
  const refusals: Refusal[] = []
  const made = new RunClient(
    {
      onreport: (report) => {
        last = report
        made.giveBack(report.frame.buffer)
      },
      onrefused: (refusal) => refusals.push(refusal),
      onprogress: () => undefined,
      onopen: () => undefined,
      onbroken: (message) => {
        throw new Error(message)
      },
      onreplaced: () => undefined,
    },
    wanted,
    () => local,
  )
  void made.open()
  return { client: made, last: () => last, refusals }
}

/** The hash of a fresh run that went there straight. */
function fresh(setup: (typeof SETUPS)[number], iteration: number): string {
  const session = new Session(setup as Setup)
  session.step(iteration)
  const hash = session.hash()
  session.free()
  return hash
}

const settled = async ({ client, last }: Subject): Promise<Report> =>
  vi.waitFor(
    () => {
      const report = last()
      if (!report?.hash || client.starting || !client.follows(report)) throw new Error('it is still on its way')
      return report
    },
    { timeout: 20_000, interval: 2 },
  )

test('2,000 random commands end where a fresh run does', async () => {
  expect(catalogue().planners.map(({ name }) => name)).toEqual(expect.arrayContaining(SETUPS.map(({ planner }) => planner)))
  for (let round = 0; round < 40; round += 1) {
    const lot = lots(round + 1)
    const among = <T>(list: readonly T[]): T => list[Math.floor(lot() * list.length)] as T
    const subject = client({ speed: Infinity })
    let setup = among(SETUPS)
    let refused = false
    subject.client.want({ start: { setup, at: 0, play: false } })
    for (let command = 0; command < 50; command += 1) {
      const kind = lot()
      if (kind < 0.15) {
        setup = { ...among(SETUPS), seed: Math.floor(lot() * 5) }
        refused = false
        subject.client.want({ start: { setup, at: Math.floor(lot() * 20), play: lot() < 0.3 } })
      } else if (kind < 0.2) {
        // After a refusal the run of before has to be there.
        if (!refused && !subject.client.starting) {
          refused = true
          subject.client.want({ start: { setup: among(REFUSED), at: 0, play: lot() < 0.5 } })
        }
      } else if (kind < 0.55) subject.client.want({ target: { at: Math.floor(lot() * 60), play: lot() < 0.3 } })
      else if (kind < 0.65) subject.client.want({ target: { play: true } })
      else if (kind < 0.75) subject.client.want({ target: { play: false } })
      else if (kind < 0.8) subject.client.want({ speed: among([Infinity, 1000, 30]) })
      else if (kind < 0.9) subject.client.want({ members: among([null, 0, 100]) })
      else if (kind < 0.93) subject.client['replace']()
      else await new Promise((passed) => setTimeout(passed, lot() * 8))
    }
    const at = Math.floor(lot() * 60)
    subject.client.want({ target: { at, play: false }, speed: Infinity })
    const { hash, iteration, status } = await settled(subject)
    if (status === 'running') expect(iteration).toBe(at)
    expect(hash, `round ${round}: ${JSON.stringify(setup)} at ${iteration}`).toBe(fresh(setup, iteration))
    subject.client.close()
  }
})

test('a seek right after a change of the run holds for the new run', async () => {
  const subject = client()
  const [first, second] = [SETUPS[0], SETUPS[1]] as [(typeof SETUPS)[number], (typeof SETUPS)[number]]
  subject.client.want({ start: { setup: first, at: 0, play: true } })
  subject.client.want({ start: { setup: second, at: 0, play: true } })
  subject.client.want({ target: { at: 40, play: false } })
  expect(await settled(subject)).toMatchObject({ planner: second.planner, iteration: 40, hash: fresh(second, 40) })
  subject.client.close()
})

test('a seek that is sent with a run that is refused holds for the run that stays', async () => {
  const subject = client()
  const setup = SETUPS[0] as (typeof SETUPS)[number]
  subject.client.want({ start: { setup, at: 3, play: false } })
  await settled(subject)
  subject.client.want({ start: { setup: REFUSED[1] as UncheckedSetup, at: 0, play: true } })
  subject.client.want({ target: { at: 25, play: false } })
  expect(await settled(subject)).toMatchObject({ iteration: 25, hash: fresh(setup, 25) })
  expect(subject.refusals).toMatchObject([{ field: 'population' }])
  // Without one it stays where it was.
  subject.client.want({ start: { setup: REFUSED[1] as UncheckedSetup, at: 0, play: true } })
  await vi.waitFor(() => expect(subject.refusals).toHaveLength(2))
  expect(await settled(subject)).toMatchObject({ iteration: 25 })
  subject.client.close()
})

test('by the clock of evaluations a run goes to its first iteration at or beyond a place, forth and back', async () => {
  const subject = client({ clock: 'evaluations' })
  const setup = SETUPS[1] as (typeof SETUPS)[number]
  subject.client.want({ start: { setup, at: 0, play: false } })
  const session = new Session(setup as Setup)
  for (const at of [1000, 130, 131, 2500, 0, 2500]) {
    subject.client.want({ target: { at, play: false } })
    const report = await settled(subject)
    session.seek(0)
    while (session.evaluations < at) session.step(1)
    expect([report.iteration, report.evaluations, report.hash]).toEqual([session.iteration, session.evaluations, session.hash()])
  }
  session.free()
  subject.client.close()
})
