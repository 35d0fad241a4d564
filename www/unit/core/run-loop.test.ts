import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import type { Desired, FromHost, Report, Start } from '../../src/engine/protocol'

/* The loop that hosts a run, with a run that does what a test says, and a clock that a test moves. */

let clock = 0
let runs: Run[] = []
/** What is other about the next run. */
let next: Partial<Run> = {}

/** A run whose steps take as long as it says, and in so many parts. */
class Run {
  readonly planner = 'slow'
  readonly scene = { kind: 'grid' }
  readonly seed = 1
  readonly parameters = {}
  readonly stages = []
  limit = 100
  end: number | undefined
  iteration = 0
  evaluations = 0
  partly = false
  /** In milliseconds. */
  cost = 1
  outcomeCost = 0
  parts = 1
  last = Number.POSITIVE_INFINITY
  tasks: unknown[] = []
  /** When steps ended. */
  steps: number[] = []
  private part = 0

  constructor() {
    Object.assign(this, next)
    runs.push(this)
  }

  get status(): string {
    return this.iteration >= this.last ? 'solved' : 'running'
  }

  advance(): string {
    clock += this.cost
    this.part += 1
    this.partly = this.part < this.parts
    if (this.partly) return 'partly'
    this.part = 0
    this.iteration += 1
    this.evaluations += 10
    this.steps.push(clock)
    return this.status
  }

  rewind = vi.fn((to: number) => {
    this.iteration = to
    this.part = 0
    this.partly = false
  })
  outcome = vi.fn(() => {
    clock += this.outcomeCost
    return { status: this.status }
  })
  trace = vi.fn((_: number) => ({ iterations: new Float64Array([this.iteration]), rows: new Float64Array() }))
  /** One an iteration, and one before the first. */
  events = vi.fn((from: number) => Array.from({ length: this.iteration + 1 }, (_, k) => ({ iteration: k })).slice(from))
  lookAt = vi.fn()
  free = vi.fn()
  supply = vi.fn()
  jobs = (): unknown[] => this.tasks
  exact = (): null => null
  readings = (): object => ({})
  hash = (): string => `hash ${this.iteration}`
  link = (): string => `#link ${this.iteration}`
  inspect = (item: unknown): object => ({ item, suppositions: [] })
  members = (): Float64Array => new Float64Array([this.iteration])
  curve = (): object => ({ evaluations: [1], values: [5] })
  layerImage = (): object => ({ image: { width: 1, height: 1 }, min: 2, max: 4, range: [2, 4] })
  frame = (): object => ({ vertices: new Float32Array(4), spans: new Uint32Array(4), thinning: 1 })
}

vi.mock('../../src/engine/host/rest', () => ({ words: vi.fn(async () => undefined), speakIn: vi.fn(async () => undefined), rest: vi.fn() }))
vi.mock('forage-lab/core', async (original) => ({ ...(await original<object>()), Session: Run }))
const { RunHost } = await import('../../src/engine/host/run-host')
const { words } = await import('../../src/engine/host/rest')

let host: InstanceType<typeof RunHost>
let said: FromHost[]
let transferred: Transferable[][]
let broken: unknown[]
let version: number
let returns: boolean

const START: Start = { setup: {} as Start['setup'], at: 0, play: false }
const want = (change: Partial<Desired>): number => {
  version += 1
  host.want(version, change)
  return version
}
const of = <K extends FromHost['is']>(is: K): (FromHost & { is: K })[] => said.filter((one): one is FromHost & { is: K } => one.is === is)
const shown = (): number => of('report').length + of('picture').length
const run = (): Run => runs.at(-1) as Run

/** Lets the loop do all that it does without waiting for the clock. */
async function calm(): Promise<void> {
  for (let k = 0; k < 12; k += 1) await new Promise((passed) => setImmediate(passed))
}

/** So many milliseconds pass, in which nothing but the clock takes time. */
async function pass(milliseconds: number, at = 1): Promise<void> {
  for (let k = 0; k < milliseconds; k += at) {
    clock += at
    vi.advanceTimersByTime(at)
    await calm()
  }
}

/** A run that stands still at its start. */
async function standing(more: Partial<Run> = {}, change: Partial<Desired> = {}): Promise<void> {
  next = more
  want({ start: { ...START }, ...change })
  await calm()
  said.length = transferred.length = 0
}

beforeEach(() => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] })
  ;[clock, runs, next, said, transferred, broken, version, returns] = [1000, [], {}, [], [], [], 0, true]
  vi.spyOn(performance, 'now').mockImplementation(() => clock)
  const [messages, travelled, errors] = [said, transferred, broken]
  const made = new RunHost((message, transfers = []) => {
    messages.push(message)
    travelled.push(transfers)
    if (returns && (message.is === 'report' || message.is === 'picture')) queueMicrotask(() => made.giveBack(message.frame.buffer))
  })
  made.onbroken = (error) => errors.push(error)
  host = made
})
afterEach(async () => {
  want({ target: { play: false } })
  await calm()
  expect(broken).toEqual([])
  vi.useRealTimers()
  vi.unstubAllGlobals()
})

describe('playing', () => {
  test('at a speed a step is taken when it is due, and nothing between', async () => {
    await standing({ cost: 0 }, { speed: 10 })
    want({ target: { play: true } })
    const begun = clock
    await pass(350)
    expect(run().steps.map((at) => at - begun)).toEqual([0, 100, 200, 300])
    // Another speed counts from now on.
    want({ speed: 20 })
    const changed = clock
    await calm()
    await pass(120)
    expect(
      run()
        .steps.slice(4)
        .map((at) => at - changed),
    ).toEqual([0, 50, 100])
  })

  test('it catches up after a short pause, and goes on from there after a long one', async () => {
    await standing({ cost: 0 }, { speed: 100 })
    want({ target: { play: true } })
    await calm()
    expect(run().iteration).toBe(1)
    await pass(200, 200)
    expect(run().iteration).toBe(21)
    await pass(400, 400)
    expect(run().iteration).toBeLessThan(24)
  })

  test('after the end no step is taken', async () => {
    await standing({ cost: 0, last: 3 }, { speed: 1000 })
    vi.mocked(words).mockClear()
    want({ target: { play: true } })
    await pass(1)
    expect(words).not.toHaveBeenCalled()
    await pass(100, 50)
    expect([run().steps.length, of('report').at(-1)?.playing, of('report').at(-1)?.arrived]).toEqual([3, false, true])
    // It may say why it ended.
    expect(words).toHaveBeenCalledTimes(1)
    // From its end it begins again.
    want({ target: { play: true } })
    await pass(1)
    expect(run().rewind).toHaveBeenCalledWith(0)
  })

  test('pictures come as often as a screen shows them, reports a few times a second', async () => {
    await standing({ cost: 0 }, { speed: 100 })
    want({ target: { play: true } })
    await pass(1000)
    const [pictures, reports] = [of('picture').length, of('report').length]
    // A step comes every 10 ms, so every second one is shown.
    expect([reports, pictures + reports]).toEqual([5, 50])
    for (const picture of of('picture')) expect(picture.generation).toBe(1)
    // By the clock of evaluations each has its numbers.
    said.length = 0
    want({ clock: 'evaluations' })
    await pass(300)
    expect([of('picture').length, of('report').length]).toEqual([0, 15])
  })

  test('what is wanted meanwhile is done at once', async () => {
    await standing({ cost: 0 }, { speed: 1 })
    want({ target: { play: true } })
    await pass(20)
    want({ target: { at: 7, play: false } })
    await calm()
    expect([run().iteration, of('report').at(-1)?.arrived]).toEqual([7, true])
    expect(vi.getTimerCount()).toBe(0)
  })
})

describe('a step that takes long', () => {
  test('is said to, once, and that it is over', async () => {
    await standing({ cost: 50, parts: 20 })
    want({ target: { at: 1, play: false } })
    await calm()
    await calm()
    expect(of('progress').map(({ done, total, generation, step }) => [done, total, generation, step])).toEqual([
      [null, 1, 1, 1],
      [0, 0, 1, 2],
    ])
    expect([run().iteration, of('report').at(-1)?.iteration]).toEqual([1, 1])
  })

  test('is not said to when it takes less than 400 ms', async () => {
    await standing({ cost: 20, parts: 20 })
    want({ target: { at: 1, play: false } })
    await calm()
    await calm()
    expect([run().iteration, of('progress')]).toEqual([1, []])
  })

  test('is given up for another place, and goes on when only its looks change', async () => {
    await standing({ cost: 50, parts: 1e6 })
    want({ target: { at: 5, play: false } })
    await calm()
    expect(run().partly).toBe(true)
    want({ speed: 7, budget: 5 })
    await calm()
    expect([run().rewind.mock.calls.length, run().partly, run().steps.length]).toEqual([0, true, 0])
    // It is shown when it is over.
    expect(shown()).toBe(0)
    want({ target: { at: 0, play: false } })
    await calm()
    expect([run().rewind.mock.calls, run().partly, of('report').at(-1)?.iteration]).toEqual([[[0]], false, 0])
  })

  test('is ended before the run stands still', async () => {
    await standing({ cost: 50, parts: 40 })
    want({ target: { play: true }, speed: 10 })
    await calm()
    want({ target: { play: false } })
    for (let k = 0; k < 5; k += 1) await calm()
    expect([run().iteration, run().partly, of('report').at(-1)?.arrived]).toEqual([1, false, true])
  })
})

test('runs that a step needs are waited for, in the state of before; what they found is supplied', async () => {
  await standing({ cost: 0 }, { speed: 10 })
  run().tasks = ['a run']
  want({ target: { play: true } })
  await pass(50)
  expect([of('subtasks').map(({ tasks }) => tasks), run().iteration, shown()]).toEqual([[['a run']], 0, 1])
  run().tasks = []
  host.provide(of('subtasks')[0]?.id ?? 0, ['found'] as never)
  await calm()
  expect([run().supply.mock.calls, run().iteration]).toEqual([[[['found']]], 1])
  expect(of('progress').at(-1)).toMatchObject({ done: 0, total: 0 })
  const count = of('progress').length
  await pass(300, 10)
  expect(of('progress')).toHaveLength(count)
})

test('a run that is replaced is freed, and one of which another is wanted before it began', async () => {
  want({ start: { ...START } })
  want({ start: { ...START } })
  await calm()
  // The first one was made, but never shown.
  expect([runs.length, runs.map(({ free }) => free.mock.calls.length), of('report').filter(({ run: fresh }) => fresh).length]).toEqual([
    2,
    [1, 0],
    1,
  ])
  want({ start: { ...START } })
  await calm()
  expect(runs.map(({ free }) => free.mock.calls.length)).toEqual([1, 1, 0])
})

test('the core is asked for the window that is looked at', async () => {
  const window = { min: [1, 2], max: [3, 4] } as never
  await standing({}, { viewport: { fields: [], window } })
  expect(run().lookAt.mock.calls).toEqual([
    [
      [1, 2],
      [3, 4],
    ],
  ])
  want({ speed: 3 })
  expect(run().lookAt).toHaveBeenCalledTimes(1)
  want({ viewport: { fields: [], window: null } })
  expect(run().lookAt).toHaveBeenLastCalledWith(undefined, undefined)
})

test('where all buffers are away the newest state is shown with the first that comes back', async () => {
  await standing({ cost: 0 }, { speed: 1000 })
  returns = false
  want({ target: { play: true } })
  await pass(100, 20)
  expect(shown()).toBe(3)
  want({ target: { play: false } })
  await calm()
  expect(shown()).toBe(3)
  host.giveBack(new ArrayBuffer(8))
  expect([shown(), of('report').at(-1)?.iteration, of('report').at(-1)?.arrived]).toEqual([4, run().iteration, true])
  // Another one has nothing to show.
  host.giveBack(new ArrayBuffer(8))
  expect(shown()).toBe(4)
})

test('what breaks down while a buffer comes back is said', async () => {
  await standing({ cost: 0 })
  returns = false
  for (let k = 0; k < 4; k += 1) {
    want({ budget: 10 + k })
    await calm()
  }
  run().frame = () => {
    throw new Error('unreachable')
  }
  host.giveBack(new ArrayBuffer(8))
  expect(broken.splice(0)).toEqual([new Error('unreachable')])
  run().frame = () => ({ vertices: new Float32Array(4), spans: new Uint32Array(4), thinning: 1 })
})

describe('reports', () => {
  const reports = (): Report[] => of('report')

  test('bring what is new from the first on, and repeat nothing', async () => {
    next = { cost: 0, end: undefined, limit: 100 }
    want({ start: { ...START } })
    await calm()
    expect(run().trace.mock.calls[0]).toEqual([-1])
    expect([reports()[0]?.repeats, reports().flatMap(({ events }) => events)]).toEqual([false, [{ iteration: 0 }]])
    for (const at of [2, 5]) {
      want({ target: { at, play: false }, underway: false })
      await calm()
    }
    expect(reports().flatMap(({ events }) => events)).toEqual([0, 1, 2, 3, 4, 5].map((iteration) => ({ iteration })))
    // An end that becomes known within the same timeline is said.
    said.length = 0
    run().end = 100
    want({ budget: 7 })
    await calm()
    expect(reports()[0]?.span).toMatchObject({ end: 100, extent: 100 })
    want({ budget: 8 })
    await calm()
    expect(reports().at(-1)?.span).toBe(null)
  })

  test('have a summary four times a second, and less often where it costs much', async () => {
    for (const [cost, apart] of [
      [0, 250],
      [50, 1000],
    ] as const) {
      await standing({ cost: 0, outcomeCost: cost }, { speed: 20, summary: true })
      await pass(2000, 50)
      want({ target: { play: true } })
      run().outcome.mockClear()
      const times: number[] = []
      run().outcome.mockImplementation(() => {
        times.push(clock)
        clock += cost
        return { status: 'running' }
      })
      await pass(3000, 5)
      const gaps = times.slice(1).map((at, k) => at - (times[k] ?? 0) - cost)
      expect(gaps.length).toBeGreaterThan(1)
      expect(Math.min(...gaps), `${gaps}`).toBeGreaterThanOrEqual(apart)
      expect(Math.max(...gaps), `${gaps}`).toBeLessThan(apart + 120)
      want({ target: { play: false } })
      await calm()
    }
  })

  test('by the clock of evaluations have the best so far when it has grown', async () => {
    want({ start: { ...START }, clock: 'evaluations' })
    await calm()
    want({ budget: 7 })
    await calm()
    const [first, ...others] = reports().map(({ curve }) => curve)
    expect(first).toEqual({ evaluations: [1], values: [5] })
    expect(others.length).toBeGreaterThan(0)
    for (const curve of others) expect(curve).toBe(null)
  })

  test('where it stays it is summed up once', async () => {
    await standing({ cost: 0 })
    run().outcome.mockClear()
    for (const budget of [5, 6]) {
      want({ budget })
      await calm()
    }
    expect([run().outcome.mock.calls.length, reports().map(({ hash }) => hash)]).toEqual([0, ['hash 0', 'hash 0']])
  })

  test('say between which values fields are, and their pictures travel', async () => {
    class Canvas {
      getContext = (): object => ({ putImageData: () => undefined })
      transferToImageBitmap = (): string => 'a picture'
    }
    vi.stubGlobal('OffscreenCanvas', Canvas)
    await standing({ cost: 0 }, { viewport: { fields: [{ role: 'pheromone', ramp: [] as never }], window: null } })
    want({ budget: 9 })
    await calm()
    expect(reports().at(-1)?.ranges).toEqual({ pheromone: [2, 4] })
    expect(transferred.at(-1)?.[1]).toBe('a picture')
  })
})
