import type { Catalogue, Planner, Scene, UncheckedSetup } from 'forage-lab'
import type { Answer, Desired, FromHost, Refusal, Report, ToHost } from '../src/engine/protocol'

/** The run that the worker has, as a line of text: what it was started with, and where it is. */
export interface State {
  planner: string
  scene: string
  seed: number
  params: Record<string, unknown>
  iteration: number
  playing: boolean
}

const planner = (name: string): Planner =>
  ({
    name,
    title: name,
    family: 'test',
    kinds: ['discs'],
    stops: false,
    parameters: ['w', 'c', 'iterations'].map((parameter) => ({ name: parameter, kinds: [], defaults: {}, default: 1 })),
    layers: [],
    members: [],
    events: [],
  }) as unknown as Planner

export const scene = (name: string): Scene =>
  ({
    format: 'forage-scene',
    version: 1,
    name,
    title: name,
    kind: 'discs',
    bounds: { min: [0, 0], max: [9, 9] },
    start: [1, 1],
    goal: [8, 8],
    discs: [],
  }) as Scene

export const catalogue = {
  planners: [planner('wcpso'), planner('pso')],
  scenes: [scene('wcpso-discs'), scene('other')],
  roles: [],
  shapes: [],
} as unknown as Catalogue

const UNLOADED: Refusal = { message: 'Failed to fetch', field: '', unloaded: true }

/** How long a run is. */
const limitOf = ({ params }: UncheckedSetup): number => Number(params?.iterations ?? 100)

/** What a page holds of a thread. */
class Thread {
  onmessage: ((event: { data: FromHost }) => void) | null = null
  onerror: unknown = null
  constructor(private readonly fake: FakeWorker) {}

  postMessage(message: ToHost): void {
    if (this.fake.thread === this) this.fake.inbox.push(message)
  }

  terminate(): void {
    this.fake.leave(this)
  }
}

/**
 * The thread that computes, by hand: it takes in what it is sent, in order, only when the test says so. Parameter values below zero are refused, and scenes with a
 * disc over the start. Links are `planner,scene,seed,iteration,hash`.
 */
export class FakeWorker {
  inbox: ToHost[] = []
  private outbox: FromHost[] = []
  thread: Thread | undefined
  /** How many threads there were. */
  threads = 0
  private version = 0
  private begun = 0
  private desired: Partial<Desired> = {}
  private setup: UncheckedSetup | undefined
  private pending = false
  private iteration = 0
  private playing = false
  private generation = 0
  private seeds = 1000
  /** A part that starts and links need cannot be loaded. */
  unloaded = false

  /** The host of the page. */
  readonly host = {
    worker: (): Worker => {
      this.threads += 1
      this.thread = new Thread(this)
      return this.thread as unknown as Worker
    },
    core: (): Promise<undefined> => this.core,
    catalogue: (): Promise<Catalogue> => Promise.resolve(catalogue),
  }
  /** Settles when a thread may be opened. */
  core: Promise<undefined> = Promise.resolve(undefined)

  /** The thread is thrown away with all that it was sent. */
  leave(thread: Thread): void {
    if (thread !== this.thread) return
    this.thread = undefined
    this.inbox = []
    this.outbox = []
    this.setup = undefined
    this.pending = false
    this.desired = {}
  }

  /** The core breaks down. */
  crash(message: string): void {
    this.deliver({ is: 'broken', message })
  }

  private deliver(message: FromHost): void {
    this.thread?.onmessage?.({ data: message })
  }

  /** How many questions and changes wait to be taken in. */
  get waiting(): number {
    return this.inbox.filter(({ is }) => is === 'want' || is === 'ask').length
  }

  private refused({ params = {}, scene: on }: UncheckedSetup): Refusal | null {
    if (this.unloaded) return UNLOADED
    const field = Object.keys(params).find((name) => Number(params[name]) < 0)
    if (field !== undefined) return { field, message: 'below zero' }
    const covered = typeof on === 'object' && on.kind === 'discs' && on.discs.some(({ center: [x, y] }) => x === 1 && y === 1)
    return covered ? { field: 'start', message: 'covered' } : null
  }

  private want({ version, change }: ToHost & { is: 'want' }): void {
    this.version = version
    Object.assign(this.desired, change)
    const { start, target } = this.desired
    if (change.start) {
      this.begun = version
      this.pending = true
    }
    if (this.pending && start) {
      this.pending = false
      const refusal = this.refused(start.setup)
      if (refusal) {
        this.outbox.push({ is: 'refused', version, refusal })
        if (target) this.go(target.at, target.play)
        return
      }
      this.setup = start.setup
      this.go((target ?? start).at, (target ?? start).play, true)
    } else if (change.target && this.setup) {
      this.go(change.target.at, change.target.play)
    }
  }

  private go(at: number | undefined, play: boolean, fresh = false): void {
    this.iteration = Math.min(at ?? this.iteration, this.setup ? limitOf(this.setup) : 0)
    this.playing = play
    if (fresh) this.generation = this.begun
    const { setup, generation, iteration, version } = this
    const limit = setup ? limitOf(setup) : 0
    const run = fresh && {
      generation,
      ...setup,
      limit,
      parameters: {},
      exact: null,
      span: { end: limit, extent: limit, stages: [] },
      evaluations: 0,
    }
    this.outbox.push({
      is: 'report',
      version,
      generation,
      run: run || null,
      planner: '',
      iteration,
      evaluations: iteration,
      furthest: { iteration },
      status: 'running',
      playing: play,
      arrived: !play,
      readings: {},
      thinning: 1,
      ranges: {},
      trace: { columns: [], iterations: new Float64Array(), rows: new Float64Array() },
      events: [],
      span: null,
      inspection: null,
      supposed: null,
      members: null,
      outcome: {},
      link: `${setup?.planner},${(setup?.scene as { name?: string } | undefined)?.name}`,
      hash: play ? null : `${setup?.planner} ${iteration}`,
      curve: null,
      frame: { buffer: new ArrayBuffer(0), vertices: 0, spans: 0, fields: [] },
    } as unknown as Report)
  }

  private readonly answers: Record<string, (...given: never[]) => unknown> = {
    suggest: (setup: UncheckedSetup): Answer<unknown> => {
      const refusal = this.refused(setup)
      return refusal ? { ok: false, refusal } : { ok: true, value: null }
    },
    parseLink: (link: string): Answer<unknown> => {
      if (this.unloaded) return { ok: false, refusal: UNLOADED }
      const [planner, on, seed, iteration, hash] = link.split(',')
      return { ok: true, value: { planner, scene: scene(on ?? ''), params: {}, seed: Number(seed), iteration: Number(iteration), hash } }
    },
    newSeed: (): number => (this.seeds += 1),
    pick: (x: number): unknown => ({ role: this.setup?.planner, index: x }),
  }

  /** The run plays on to an iteration. */
  advance(iteration: number): void {
    this.go(iteration, this.playing)
  }

  /** Sends the picture of the present state once more. */
  repeat(): void {
    this.go(this.iteration, this.playing)
    this.show()
  }

  /** Takes in the next message; its answer, and its pictures if they are not held back, come to the page. */
  async receive(pictures = true): Promise<void> {
    const message = this.inbox.shift()
    if (message?.is === 'buffer') return this.receive(pictures)
    if (message) this.deliver({ is: 'seen', number: message.number })
    if (message?.is === 'open') this.deliver({ is: 'open' })
    if (message?.is === 'want') this.want(message)
    if (message?.is === 'ask') {
      const { name, given } = message.question
      this.deliver({ is: 'answer', number: message.number, value: this.answers[name]?.(...(given as never[])) })
    }
    if (pictures) this.show()
    await passed()
  }

  show(): void {
    const { outbox } = this
    this.outbox = []
    for (const message of outbox) this.deliver(message)
  }

  /** Takes in everything, also what the page asks for because of it. */
  async receiveAll(): Promise<void> {
    await passed()
    while (this.inbox.length > 0) await this.receive()
    this.show()
    await passed()
    if (this.inbox.length > 0) await this.receiveAll()
  }

  get state(): State {
    const { planner: name = '', scene: on, seed, params = {} } = this.setup ?? {}
    const { iteration, playing } = this
    return { planner: name, scene: (on as Scene | undefined)?.name ?? '', seed: Number(seed), params, iteration, playing }
  }
}

/** All that waits for an answer that is there has gone on. */
export const passed = (): Promise<void> => new Promise((resolve) => setTimeout(resolve))
