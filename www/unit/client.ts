/* A client of a run whose thread does nothing by itself. */
import { afterEach, beforeEach, vi } from 'vitest'
import type { Host } from '../src/engine/host'
import type { Desired, FromHost, Report, Start, ToHost } from '../src/engine/protocol'
import { type Listeners, RunClient } from '../src/engine/run-client'
import { language } from '../src/locales/language.svelte'

/** A thread that only remembers what it was sent, and says what a test has it say. */
class Thread {
  onmessage: ((event: { data: FromHost }) => void) | null = null
  onerror: ((event: { message: string; preventDefault(): void }) => void) | null = null
  sent: ToHost[] = []
  transferred: unknown[] = []
  ended = false
  constructor(readonly kind: string) {}
  postMessage(message: ToHost, transfers: unknown[]): void {
    this.sent.push(message)
    this.transferred.push(...transfers)
  }
  terminate(): void {
    this.ended = true
  }
  say(data: FromHost): void {
    this.onmessage?.({ data })
  }
  /** All that was sent is received. */
  see(): void {
    this.say({ is: 'seen', number: Math.max(...this.sent.map(({ number }) => number)) })
  }
  wants(): Partial<Desired>[] {
    return this.sent.flatMap((message) => (message.is === 'want' ? [message.change] : []))
  }
  last<K extends ToHost['is']>(is: K): (ToHost & { is: K }) | undefined {
    return this.sent.findLast((message): message is ToHost & { is: K } => message.is === is)
  }
}

export let threads: Thread[] = []
/** What listeners were called with, after their names. */
export let calls: unknown[][] = []
export let client: RunClient

/** Each test has a client of its own, and moves the time itself. */
export function eachByItself(): void {
  beforeEach(() => {
    vi.useFakeTimers()
    ;[threads, calls] = [[], []]
  })
  afterEach(() => {
    client.close()
    language.tag = 'en'
    vi.useRealTimers()
  })
}

export const thread = (): Thread => threads.at(-1) as Thread
export const host: Host = {
  worker: (kind) => {
    threads.push(new Thread(kind))
    return thread() as unknown as Worker
  },
  core: () => Promise.resolve('core' as never),
  files: () => Promise.resolve('files' as never),
  catalogue: () => Promise.reject(new Error('nobody asks for it')),
}

export const named =
  (name: keyof Listeners): ((...given: unknown[]) => void) =>
  (...given) =>
    void calls.push([name, ...given])
export const called = (name: keyof Listeners): unknown[][] => calls.filter(([which]) => which === name).map(([, ...given]) => given)

export function made(more: Partial<Listeners> = {}, wanted: Partial<Desired> = {}, hosting = host): RunClient {
  const listeners: Listeners = {
    onreport: named('onreport'),
    onrefused: named('onrefused'),
    onprogress: named('onprogress'),
    onopen: named('onopen'),
    onbroken: named('onbroken'),
    onreplaced: named('onreplaced'),
    ...more,
  }
  client = new RunClient(listeners, wanted, () => hosting)
  return client
}

const setup = (seed: number, more: object = {}): Start['setup'] =>
  ({ planner: 'pso', scene: 'sphere', params: {}, seed, ...more }) as Start['setup']
export const start = (seed: number, at = 0, play = false, more: object = {}): Start => ({ setup: setup(seed, more), at, play })
export const CODE = { code: 'register({})' }

/** A report; of a run that is new, if it has a generation. */
export function report(version: number, iteration: number, more: Partial<Report> & { fresh?: number } = {}): Report {
  const { fresh, ...rest } = more
  return {
    is: 'report',
    version,
    generation: fresh ?? 1,
    run: fresh === undefined ? null : { generation: fresh },
    iteration,
    evaluations: 10 * iteration,
    playing: false,
    arrived: true,
    frame: { buffer: new ArrayBuffer(8) },
    ...rest,
  } as unknown as Report
}

/** A client whose thread is there and runs a setup. */
export async function running(first: Start = start(1), more: Partial<Listeners> = {}): Promise<void> {
  made(more)
  client.want({ start: first })
  await client.open()
  thread().see()
  thread().say(report(client.version, first.at, { fresh: client.version, playing: first.play, arrived: !first.play }))
}
