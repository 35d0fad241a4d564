import type { Catalogue, Planner, Scene, UncheckedSetup } from 'forage-lab'
import type { Answer, FrameMessage, Opening, Run } from '../src/engine/protocol'

/** The run that the worker has, as a line of text: what it was started with, and where it is. */
export interface State {
  planner: string
  scene: string
  seed: number
  params: Record<string, unknown>
  iteration: number
  playing: boolean
}

interface Listeners {
  onframe(frame: FrameMessage): void
  oncrash(message: string): void
  onunresponsive(): void
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

const catalogue = {
  planners: [planner('wcpso'), planner('pso')],
  scenes: [scene('wcpso-discs'), scene('other')],
  roles: [],
  shapes: [],
} as unknown as Catalogue

const UNLOADED: Answer<never> = { ok: false, refusal: { message: 'Failed to fetch', field: '', unloaded: true } }

/** How long a run is. */
const limitOf = ({ params }: UncheckedSetup): number => Number(params?.iterations ?? 100)

/**
 * The thread that computes, by hand: it takes in what it is asked, in order, only when the test says so. Parameter values below zero are refused, and scenes with a
 * disc over the start. Links are `planner,scene,seed,iteration,hash`.
 */
export class FakeWorker {
  private readonly inbox: (() => void)[] = []
  private frames: FrameMessage[] = []
  private setup: UncheckedSetup | undefined
  private generation = 0
  private iteration = 0
  private playing = false
  private request = 0
  private seeds = 1000
  /** A part that starts and links need cannot be loaded. */
  unloaded = false

  constructor(readonly listeners: Listeners) {}

  /** Settles when the thread is there. */
  opens: Promise<Catalogue> = Promise.resolve(catalogue)
  open = (): Promise<Catalogue> => this.opens
  giveBack = (): void => undefined
  /** How often it was looked whether the thread answers. */
  expected = 0
  expect = (): void => {
    this.expected += 1
  }
  /** The thread is thrown away with all that it was asked. */
  close = (): void => {
    this.inbox.length = 0
    this.frames = []
    this.setup = undefined
    this.generation = 0
  }

  readonly api = {
    start: (setup: UncheckedSetup, { at, play }: Opening, request: number): Promise<Answer<Run>> =>
      this.answer(() => {
        const refused = this.unloaded ? UNLOADED : this.refused(setup)
        if (refused) return refused
        this.request = request
        this.setup = setup
        this.generation += 1
        this.go(at, play)
        return {
          ok: true,
          value: {
            generation: this.generation,
            ...setup,
            limit: limitOf(setup),
            parameters: {},
            exact: null,
            span: { end: limitOf(setup), extent: limitOf(setup), stages: [] },
          } as unknown as Run,
        }
      }),
    seek: (iteration: number, play: boolean, request: number): Promise<void> =>
      this.answer(() => {
        this.request = request
        this.go(iteration, play)
      }),
    play: (request: number): Promise<void> =>
      this.answer(() => {
        this.request = request
        this.go(this.iteration, true)
      }),
    pause: (request: number): Promise<void> =>
      this.answer(() => {
        this.request = request
        this.go(this.iteration, false)
      }),
    suggest: (setup: UncheckedSetup): Promise<unknown> => this.answer(() => this.refused(setup) ?? { ok: true, value: null }),
    parseLink: (link: string): Promise<unknown> =>
      this.answer(() => {
        if (this.unloaded) return UNLOADED
        const [planner, on, seed, iteration, hash] = link.split(',')
        const value = { planner, scene: scene(on ?? ''), params: {}, seed: Number(seed), iteration: Number(iteration), hash }
        return { ok: true, value }
      }),
    newSeed: (): Promise<number> => this.answer(() => (this.seeds += 1)),
    pick: (x: number): Promise<unknown> => this.answer(() => ({ role: this.setup?.planner, index: x })),
    watch: (): Promise<void> => this.answer(() => undefined),
    drawn: (): Promise<void> => Promise.resolve(),
    speed: (): Promise<void> => Promise.resolve(),
  }

  /** How many messages wait to be taken in. */
  get waiting(): number {
    return this.inbox.length
  }

  private answer<T>(act: () => T): Promise<T> {
    return new Promise((resolve) => this.inbox.push(() => resolve(act())))
  }

  private refused({ params = {}, scene: on }: UncheckedSetup): Answer<never> | null {
    const field = Object.keys(params).find((name) => Number(params[name]) < 0)
    if (field !== undefined) return { ok: false, refusal: { field, message: 'below zero' } }
    const covered = typeof on === 'object' && on.kind === 'discs' && on.discs.some(({ center: [x, y] }) => x === 1 && y === 1)
    return covered ? { ok: false, refusal: { field: 'start', message: 'covered' } } : null
  }

  private go(iteration: number, play: boolean): void {
    this.iteration = this.setup ? Math.min(iteration, limitOf(this.setup)) : 0
    this.playing = play
    this.frames.push({
      type: 'frame',
      planner: '',
      generation: this.generation,
      iteration: this.iteration,
      computed: this.iteration,
      status: 'running',
      playing: play,
      request: this.request,
      readings: {},
      fields: [],
      trace: { columns: [], iterations: new Float64Array(), rows: new Float64Array() },
      events: [],
      span: null,
      inspection: null,
      members: null,
      report: { outcome: {}, link: '', settledHash: play ? null : `${this.setup?.planner} ${this.iteration}` },
    } as unknown as FrameMessage)
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

  /** Takes in the next message; its answer and pictures come to the page. */
  async receive(pictures = true): Promise<void> {
    this.inbox.shift()?.()
    if (pictures) this.show()
    await passed()
  }

  show(): void {
    const frames = this.frames
    this.frames = []
    for (const frame of frames) this.listeners.onframe(frame)
  }

  /** Takes in everything, also what the page asks for because of it. */
  async receiveAll(): Promise<void> {
    await passed()
    while (this.inbox.length > 0) await this.receive()
    this.show()
  }

  get state(): State {
    const { planner: name = '', scene: on, seed, params = {} } = this.setup ?? {}
    const { iteration, playing } = this
    return { planner: name, scene: (on as Scene | undefined)?.name ?? '', seed: Number(seed), params, iteration, playing }
  }
}

/** All that waits for an answer that is there has gone on. */
export const passed = (): Promise<void> => new Promise((resolve) => setTimeout(resolve))
