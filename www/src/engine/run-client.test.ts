import { beforeEach, describe, expect, test, vi } from 'vitest'
import { calls, called, client, eachByItself, host, made, named, report, running, start, thread, threads } from '../../unit/client'
import { language } from '../locales/language.svelte'
import { DEFAULTS, type FromHost, type Refusal } from './protocol'

const runner = { carryOut: vi.fn(), drop: vi.fn() }
vi.mock('./subtasks', () => ({
  SubtaskRunner: class {
    carryOut = runner.carryOut
    drop = runner.drop
  },
}))

eachByItself()
beforeEach(() => {
  runner.carryOut.mockReset()
  runner.drop.mockReset()
})

describe('opening', () => {
  test('begins with the core, all that is wanted, and what was asked, in this order', async () => {
    made({}, { speed: 5, budget: 7 })
    client.want({ start: start(1, 3), item: null })
    void client.api.newSeed()
    expect(threads).toHaveLength(0)
    const opening = client.open()
    // Nothing is sent before the core is there.
    expect([thread().kind, thread().sent]).toEqual(['run', []])
    client.want({ members: 9 })
    expect(thread().sent).toEqual([])
    await opening
    expect(thread().sent.map(({ is }) => is)).toEqual(['open', 'want', 'ask'])
    expect(thread().sent[0]).toMatchObject({ core: 'core', files: 'files' })
    expect(thread().wants()).toEqual([{ ...DEFAULTS, speed: 5, budget: 7, start: start(1, 3), target: null, members: 9 }])
    expect(thread().sent[2]).toMatchObject({ question: { name: 'newSeed', given: [] } })
    const numbers = thread().sent.map(({ number }) => number)
    expect(numbers).toEqual([...numbers].sort((a, b) => a - b))
    expect(new Set(numbers).size).toBe(3)
    expect(client.starting).toBe(true)
    thread().say({ is: 'open' })
    expect(called('onopen')).toEqual([[]])
  })

  test('does without files where the host has none', async () => {
    const { files: _, ...bare } = host
    made({}, {}, bare)
    await client.open()
    expect(thread().sent[0]).toMatchObject({ is: 'open', core: 'core', files: undefined })
  })

  test('twice ends the first thread, whose core comes too late', async () => {
    made()
    await Promise.all([client.open(), client.open()])
    expect(threads.map(({ ended, sent }) => [ended, sent.length])).toEqual([
      [true, 0],
      [false, 2],
    ])
    threads[0]?.say({ is: 'open' })
    threads[0]?.onerror?.({ message: 'late', preventDefault: () => undefined })
    expect(calls).toEqual([])
  })

  test('follows the language of the page while it is open', async () => {
    made()
    language.tag = 'zh-CN'
    await client.open()
    expect(thread().wants()[0]?.language).toBe('zh-CN')
    language.tag = 'en'
    for (const tell of language.listeners) tell()
    expect(thread().wants().at(-1)).toEqual({ language: 'en' })
    client.close()
    const sent = thread().sent.length
    for (const tell of language.listeners) tell()
    expect([thread().sent.length, language.listeners.size]).toEqual([sent, 0])
  })

  test('a client knows the language of the page before it is open', () => {
    language.tag = 'zh-CN'
    made()
    expect(client.desired.language).toBe('zh-CN')
  })
})

describe('what is wanted', () => {
  beforeEach(() => running(start(1, 3)))

  test('is numbered, and sent with its number', () => {
    const { version } = client
    expect([client.want({ speed: 1 }), client.want({ speed: 2 })]).toEqual([version + 1, version + 2])
    expect(thread().last('want')).toMatchObject({ version: version + 2, change: { speed: 2 } })
    expect(client.desired.speed).toBe(2)
  })

  test('a start forgets where the run before was to go, unless it says so itself', () => {
    client.want({ target: { at: 9, play: true } })
    client.want({ start: start(2) })
    expect(client.desired.target).toBe(null)
    expect(thread().last('want')?.change).toEqual({ start: start(2), target: null })
    client.want({ start: start(3), target: { at: 4, play: false } })
    expect(client.desired.target).toEqual({ at: 4, play: false })
  })

  test('reports follow it when they are as new as the newest start or target', () => {
    const seek = client.want({ target: { at: 5, play: false } })
    client.want({ speed: 3 })
    expect([seek - 1, seek, seek + 1].map((version) => client.follows({ version }))).toEqual([false, true, true])
    const begin = client.want({ start: start(2) })
    expect([client.follows({ version: seek + 1 }), client.follows({ version: begin })]).toEqual([false, true])
  })

  test('a run heads where it was wanted last, until it is there', () => {
    expect(client.heading).toEqual({ play: false })
    const version = client.want({ target: { at: 20, play: true } })
    expect(client.heading).toEqual({ at: 20, play: true })
    // A report of before says nothing of it.
    thread().say(report(version - 1, 3))
    expect(client.heading).toEqual({ at: 20, play: true })
    thread().say(report(version, 12, { playing: true, arrived: false }))
    expect(client.heading).toEqual({ at: 20, play: true })
    thread().say(report(version, 20, { playing: true, arrived: false }))
    expect(client.heading).toEqual({ play: true })
    thread().say(report(version, 100))
    expect(client.heading).toEqual({ play: false })
  })

  test('a run that is on its way and does not play yet heads there still', () => {
    const version = client.want({ target: { at: 20, play: true } })
    thread().say(report(version, 25, { playing: false, arrived: false }))
    expect(client.heading).toEqual({ at: 20, play: true })
  })

  test('of a run that plays from where it is, any report says that it plays', () => {
    const version = client.want({ target: { play: true } })
    thread().say(report(version, 3, { playing: true, arrived: false }))
    expect(client.heading).toEqual({ play: true })
  })

  test('a start heads where it begins, or where it was wanted since', () => {
    const begin = client.want({ start: start(2, 7, true) })
    expect([client.starting, client.heading]).toEqual([true, { at: 7, play: true }])
    client.want({ target: { at: 30, play: false } })
    expect(client.heading).toEqual({ at: 30, play: false })
    thread().say(report(begin, 0, { fresh: begin, arrived: false }))
    expect([client.starting, client.heading]).toEqual([false, { at: 30, play: false }])
  })

  test('a run that begins heads where its start says', () => {
    const begin = client.want({ start: start(2, 7, true) })
    thread().say(report(begin - 1, 3))
    expect(client.starting).toBe(true)
    thread().say(report(begin, 7, { fresh: begin, playing: false, arrived: false }))
    expect([client.starting, client.heading]).toEqual([false, { at: 7, play: true }])
  })

  test('of two starts the first run is not the newest', () => {
    const first = client.want({ start: start(2) })
    const second = client.want({ start: start(3, 8, true) })
    thread().say(report(first, 0, { fresh: first }))
    expect([client.starting, client.heading]).toEqual([true, { at: 8, play: true }])
    thread().say(report(second, 8, { fresh: second, arrived: false, playing: true }))
    expect([client.starting, client.heading]).toEqual([false, { play: true }])
  })

  test('an item is one of the run in which it was chosen', () => {
    client.want({ item: { role: 'particles', index: 1 } as never })
    let begin = client.want({ start: start(2) })
    thread().say(report(begin, 0, { fresh: begin }))
    expect(client.desired.item).toBe(null)
    begin = client.want({ start: start(3) })
    const item = { role: 'particles', index: 2 } as never
    client.want({ item })
    thread().say(report(begin, 0, { fresh: begin }))
    expect(client.desired.item).toBe(item)
    begin = client.want({ start: start(4), item })
    thread().say(report(begin, 0, { fresh: begin }))
    expect(client.desired.item).toBe(item)
  })

  test('of two starts the one that is reported is the run', async () => {
    client.want({ start: start(2) })
    const begin = client.want({ start: start(3) })
    thread().say(report(begin, 0, { fresh: begin }))
    // A thread that does not receive: the next one begins with the run that is there.
    await vi.advanceTimersByTimeAsync(3100)
    expect(client.desired.start).toEqual(start(3))
  })

  test('a start that is refused leaves the run of before, with what was wanted of it', () => {
    const refusal: Refusal = { message: 'no', field: 'population' }
    const before = client.desired.start
    const begin = client.want({ start: start(2, 0, true) })
    thread().say({ is: 'refused', version: begin, refusal })
    expect(called('onrefused')).toEqual([[refusal, begin]])
    expect([client.starting, client.desired.start, client.heading]).toEqual([false, before, { play: false }])
    const again = client.want({ start: start(3) })
    client.want({ target: { at: 11, play: false } })
    thread().say({ is: 'refused', version: again, refusal })
    expect([client.heading, client.desired.target]).toEqual([
      { at: 11, play: false },
      { at: 11, play: false },
    ])
  })

  test('a refusal of one start says nothing of the next', () => {
    const first = client.want({ start: start(2) })
    client.want({ start: start(3, 5) })
    thread().say({ is: 'refused', version: first, refusal: { message: 'no', field: '' } })
    expect([client.starting, client.desired.start, client.heading]).toEqual([true, start(3, 5), { at: 5, play: false }])
  })
})

test('before there is a run a report is passed on, and changes nothing', async () => {
  made()
  await client.open()
  thread().say(report(client.version, 0))
  expect([called('onreport').length, client.heading]).toEqual([1, { play: false }])
})

test('the first start that is refused leaves nothing', async () => {
  made()
  await client.open()
  const begin = client.want({ start: start(1) })
  thread().say({ is: 'refused', version: begin, refusal: { message: 'no', field: '' } })
  expect([client.starting, client.heading, client.desired.start]).toEqual([false, { play: false }, start(1)])
})

test('by the clock of evaluations a run is where its evaluations are', async () => {
  made({}, { clock: 'evaluations' })
  client.want({ start: start(1) })
  await client.open()
  thread().say(report(client.version, 0, { fresh: client.version }))
  const version = client.want({ target: { at: 120, play: true } })
  thread().say(report(version, 11, { playing: true, arrived: false }))
  expect(client.heading).toEqual({ at: 120, play: true })
  thread().say(report(version, 12, { playing: true, arrived: false }))
  expect(client.heading).toEqual({ play: true })
})

describe('what a thread says', () => {
  test('reaches who listens', async () => {
    await running(start(1), { onpicture: named('onpicture'), onaccepted: named('onaccepted') })
    const { frame, generation, planner, iteration } = report(1, 4)
    const picture = { is: 'picture', frame, generation, planner, iteration } as const
    thread().say(picture)
    thread().say({ is: 'accepted', version: 6 })
    const progress = { is: 'progress', generation: 1, step: 2, done: 1, total: 3 } as const
    thread().say(progress)
    thread().say({ ...progress, total: 0 })
    expect(called('onpicture')).toEqual([[picture]])
    expect(called('onaccepted')).toEqual([[6]])
    expect(called('onprogress')).toEqual([[progress], [null]])
    expect(called('onreport')).toHaveLength(1)
  })

  test('goes back as a buffer where nobody wants pictures', async () => {
    await running()
    const { frame, generation, planner, iteration } = report(1, 4)
    thread().say({ is: 'picture', frame, generation, planner, iteration })
    thread().say({ is: 'accepted', version: 6 })
    expect(thread().last('buffer')).toEqual({ is: 'buffer', number: 0, buffer: frame.buffer })
    expect(thread().transferred).toEqual([frame.buffer])
  })

  test('answers questions by their numbers', async () => {
    await running()
    const [first, second] = [client.api.newSeed(), client.api.pick(1, 2, 3)]
    const [one, two] = thread()
      .sent.filter(({ is }) => is === 'ask')
      .map(({ number }) => number) as [number, number]
    expect(thread().last('ask')).toMatchObject({ question: { name: 'pick', given: [1, 2, 3] } })
    thread().say({ is: 'answer', number: 10_000, value: 'nobody asked' })
    thread().say({ is: 'answer', number: two, value: 'second' })
    thread().say({ is: 'answer', number: one, error: 'wrong' })
    await expect(first).rejects.toThrow('wrong')
    expect(await second).toBe('second')
  })

  test('breaks it down by an error, or by saying so: the next thread begins where the run was', async () => {
    await running(start(1, 3, true))
    thread().say(report(client.version, 9, { playing: true, arrived: false }))
    const question = client.api.newSeed()
    const preventDefault = vi.fn()
    thread().onerror?.({ message: '', preventDefault })
    expect(preventDefault).toHaveBeenCalled()
    await expect(question).rejects.toMatchObject({ name: 'Gone', message: 'worker' })
    expect([called('onbroken'), thread().ended]).toEqual([[['worker']], true])
    expect(client.desired).toMatchObject({ start: start(1, 9, false), target: null })
    await client.open()
    // It is not asked again: that may be why.
    expect(thread().sent.map(({ is }) => is)).toEqual(['open', 'want'])
    thread().say({ is: 'broken', message: 'unreachable' })
    expect(called('onbroken')).toEqual([['worker'], ['unreachable']])
    thread().onerror?.({ message: 'too late', preventDefault })
    expect(called('onbroken')).toHaveLength(2)
  })

  test('a start that breaks it down is begun by the next, at rest', async () => {
    await running(start(1, 3))
    client.want({ start: start(2, 5, true) })
    thread().say({ is: 'broken', message: 'unreachable' })
    expect(client.desired).toMatchObject({ start: start(2, 5, false), target: null })
    await client.open()
    expect([client.starting, client.heading]).toEqual([true, { at: 5, play: false }])
  })
})

/** The module comes when it is asked for. */
const begun = (check: () => void): Promise<void> => vi.waitFor(check, { timeout: 20_000 })

describe('runs of other planners', () => {
  const request = (id: number, tasks: number): FromHost =>
    ({
      is: 'subtasks',
      id,
      generation: 4,
      step: 7,
      planner: 'pso-tuning',
      scene: 'a',
      tasks: Array.from({ length: tasks }, (_, k) => k),
    }) as never

  beforeEach(() => running())

  test('are carried out, reported not too often, and handed over', async () => {
    let progress: (done: number) => void = () => undefined
    let end: (results: unknown) => void = () => undefined
    runner.carryOut.mockImplementation((_, __, tell) => {
      progress = tell
      return new Promise((resolve) => (end = resolve))
    })
    await vi.advanceTimersByTimeAsync(1000)
    thread().say(request(3, 2))
    await begun(() => expect(runner.carryOut).toHaveBeenCalledWith({ planner: 'pso-tuning', scene: 'a' }, [0, 1], expect.anything()))
    progress(0)
    progress(1)
    await vi.advanceTimersByTimeAsync(100)
    progress(1)
    expect(called('onprogress')).toEqual([0, 1].map((done) => [{ is: 'progress', generation: 4, step: 7, done, total: 2 }]))
    end(['found'])
    await vi.advanceTimersByTimeAsync(0)
    expect(thread().last('results')).toMatchObject({ id: 3, results: ['found'] })
  })

  test('are dropped when they are not needed any more, or the client is closed', async () => {
    runner.carryOut.mockResolvedValue(null)
    thread().say(request(3, 2))
    await begun(() => expect(runner.carryOut).toHaveBeenCalled())
    await vi.advanceTimersByTimeAsync(0)
    expect(thread().last('results')).toMatchObject({ id: 3, results: null })
    thread().say(request(3, 0))
    expect([runner.drop.mock.calls.length, runner.carryOut.mock.calls.length]).toEqual([1, 1])
    client.close()
    expect(runner.drop).toHaveBeenCalledTimes(2)
  })

  test('that are not needed any more before they have begun are not carried out', async () => {
    thread().say(request(3, 2))
    thread().say(request(3, 0))
    await vi.advanceTimersByTimeAsync(10)
    expect(runner.carryOut).not.toHaveBeenCalled()
  })

  test('of a thread that is gone are handed to no other', async () => {
    let end: (results: unknown) => void = () => undefined
    runner.carryOut.mockImplementation(() => new Promise((resolve) => (end = resolve)))
    thread().say(request(3, 2))
    await begun(() => expect(runner.carryOut).toHaveBeenCalled())
    await client.open()
    end(['found'])
    await vi.advanceTimersByTimeAsync(0)
    expect(thread().last('results')).toBeUndefined()
  })
})
