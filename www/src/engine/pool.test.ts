import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import { language } from '../locales/language.svelte'
import { useHost } from './host'
import { Aborted, pool as common, WorkerPool } from './pool'

const noThreads = (): Worker => {
  throw new Error('no threads here')
}

/** A thread that does nothing by itself. */
class Idle extends EventTarget {
  onerror: ((event: { message: string; preventDefault(): void }) => void) | null = null
  postMessage = vi.fn()
  terminate = vi.fn()
}

const rest = { core: () => Promise.resolve(undefined), catalogue: () => Promise.reject(new Error('nobody asks for it')) }

test('a task fails where no thread can be started, and so does the next', async () => {
  useHost({ ...rest, worker: noThreads })
  const pool = new WorkerPool(1)
  await expect(pool.run(() => Promise.resolve(1))).rejects.toThrow('no threads here')
  await expect(pool.run(() => Promise.resolve(1))).rejects.toThrow('no threads here')
})

test('as many tasks as there may be threads are carried out at a time; one that is called off while it waits is not begun', async () => {
  const worker = vi.fn(() => new Idle() as unknown as Worker)
  useHost({ ...rest, worker })
  const pool = new WorkerPool(2)
  let [end, begun] = [(): void => undefined, 0]
  const task = (): Promise<number> =>
    new Promise((resolve) => {
      begun += 1
      end = () => resolve(begun)
    })
  const controller = new AbortController()
  void pool.run(task)
  const second = pool.run(task)
  const third = pool.run(task, { waiting: controller.signal })
  const fourth = pool.run(task)
  expect([begun, worker.mock.calls.length]).toEqual([2, 2])
  controller.abort()
  await expect(third).rejects.toBeInstanceOf(Aborted)
  end()
  expect(await second).toBe(2)
  await vi.waitFor(() => expect(begun).toBe(3))
  end()
  expect(await fourth).toBe(3)
  // The thread of the second task was free for the fourth.
  expect(worker).toHaveBeenCalledTimes(2)
})

test('a thread in which somebody’s code does not end is ended, and another one takes its place', async () => {
  vi.useFakeTimers()
  try {
    const threads: Idle[] = []
    useHost({
      ...rest,
      worker: () => {
        const thread = new Idle()
        // It answers once, then no more.
        thread.postMessage.mockImplementationOnce(({ id }: { id: string }) => {
          thread.dispatchEvent(new MessageEvent('message', { data: { id, type: 'RAW', value: undefined } }))
        })
        threads.push(thread)
        return thread as unknown as Worker
      },
    })
    const pool = new WorkerPool(1)
    const endless = (): Promise<never> => new Promise(() => undefined)
    // What is not somebody's has all the time that it takes.
    void pool.run(endless)
    await vi.advanceTimersByTimeAsync(60_000)
    expect(threads[0]?.terminate).not.toHaveBeenCalled()
    const other = new WorkerPool(1)
    const stuck = expect(other.run(endless, { watched: true })).rejects.toThrow('could not be stopped')
    const next = other.run(() => Promise.resolve('next'))
    await vi.advanceTimersByTimeAsync(10_000)
    await stuck
    expect(threads[1]?.terminate).toHaveBeenCalled()
    expect(await next).toBe('next')
  } finally {
    vi.useRealTimers()
  }
})

test('there are as many threads as cores, one at least, and all tasks of the page share them', () => {
  for (const [cores, threads] of [
    [6, 6],
    [1, 1],
    [0, 2],
    [undefined, 2],
    [-1, 1],
  ]) {
    vi.stubGlobal('navigator', { hardwareConcurrency: cores })
    expect(new WorkerPool().size).toBe(threads)
  }
  expect(common()).toBeInstanceOf(WorkerPool)
  expect(common()).toBe(common())
  vi.unstubAllGlobals()
})

/** A thread that answers whatever it is asked, and remembers what that was. */
class Answering extends Idle {
  asked: string[] = []
  override postMessage = vi.fn(({ id, path, argumentList = [] }: { id: string; path?: string[]; argumentList?: { value: unknown }[] }) => {
    this.asked.push([path?.join('.'), ...argumentList.map(({ value }) => String(value))].join(' '))
    const answer = new MessageEvent('message', { data: { id, type: 'RAW', value: undefined } })
    queueMicrotask(() => this.dispatchEvent(answer))
  })
}

describe('a pool', () => {
  let threads: Answering[]
  let host: Parameters<typeof useHost>[0]

  beforeEach(() => {
    vi.useFakeTimers()
    threads = []
    host = {
      ...rest,
      worker: (kind) => {
        expect(kind).toBe('trial')
        const thread = new Answering()
        threads.push(thread)
        return thread as unknown as Worker
      },
    }
    useHost(host)
  })
  afterEach(() => {
    vi.useRealTimers()
    language.tag = 'en'
  })

  const endless = (): Promise<never> => new Promise(() => undefined)

  test('asks no thread for anything but its tasks, in the language of the core', async () => {
    const pool = new WorkerPool(1)
    expect(await pool.run(() => Promise.resolve(1))).toBe(1)
    expect(threads[0]?.asked).toEqual([])
  })

  test('says to a thread what language the page speaks, once and before its next task', async () => {
    const pool = new WorkerPool(1)
    const seen: string[][] = []
    const task = async (): Promise<void> => void seen.push([...(threads[0]?.asked ?? [])])
    language.tag = 'zh-CN'
    for (let k = 0; k < 2; k += 1) await pool.run(task)
    language.tag = 'en'
    await pool.run(task)
    const chinese = ['speakIn zh-CN']
    expect(seen).toEqual([chinese, chinese, [...chinese, 'speakIn en']])
  })

  test('hands a thread the files of its host before its first task', async () => {
    useHost({ ...host, files: () => Promise.resolve('files' as never) })
    const pool = new WorkerPool(1)
    const seen: string[][] = []
    for (let k = 0; k < 2; k += 1) await pool.run(async () => void seen.push([...(threads[0]?.asked ?? [])]))
    expect(seen).toEqual([['open files'], ['open files']])
  })

  test('fails with what a thread breaks down with, and goes on with another one', async () => {
    const pool = new WorkerPool(1)
    for (const [message, said] of [
      ['out of memory', 'out of memory'],
      ['', 'worker'],
    ] as const) {
      const failed = expect(pool.run(endless)).rejects.toThrow(said)
      await vi.advanceTimersByTimeAsync(0)
      const preventDefault = vi.fn()
      threads.at(-1)?.onerror?.({ message, preventDefault })
      await failed
      expect(preventDefault).toHaveBeenCalled()
      expect(threads.at(-1)?.terminate).toHaveBeenCalled()
    }
    expect(await pool.run(() => Promise.resolve(1))).toBe(1)
    expect(threads).toHaveLength(3)
  })

  test('fails with what a task fails with, whatever that is', async () => {
    const pool = new WorkerPool(1)
    await expect(pool.run(() => Promise.reject(new RangeError('too far')))).rejects.toBeInstanceOf(RangeError)
    await expect(pool.run(() => Promise.reject('a text' as unknown as Error))).rejects.toThrow('a text')
  })

  test('begins no task that was called off before', async () => {
    const begun = vi.fn(endless)
    const pool = new WorkerPool(1)
    await expect(pool.run(begun, { signal: AbortSignal.abort() })).rejects.toBeInstanceOf(Aborted)
    await expect(pool.run(begun, { waiting: AbortSignal.abort() })).rejects.toMatchObject({ name: 'Aborted' })
    expect([begun.mock.calls.length, threads.length]).toEqual([0, 0])
  })

  test('drops a task that waits when either of its signals calls it off', async () => {
    const pool = new WorkerPool(1)
    void pool.run(endless)
    const begun = vi.fn(endless)
    for (const option of ['signal', 'waiting']) {
      const controller = new AbortController()
      const dropped = expect(pool.run(begun, { [option]: controller.signal })).rejects.toBeInstanceOf(Aborted)
      controller.abort()
      await dropped
    }
    expect(begun).not.toHaveBeenCalled()
  })

  test('asks a task to stop that is called off, and ends its thread when it does not', async () => {
    const pool = new WorkerPool(1)
    const controller = new AbortController()
    const failed = expect(pool.run(endless, { signal: controller.signal })).rejects.toBeInstanceOf(Aborted)
    await vi.advanceTimersByTimeAsync(0)
    controller.abort()
    await vi.advanceTimersByTimeAsync(700)
    expect([threads[0]?.asked, threads[0]?.terminate.mock.calls.length]).toEqual([['stop'], 0])
    await vi.advanceTimersByTimeAsync(200)
    await failed
    expect(threads[0]?.terminate).toHaveBeenCalled()
  })

  test('keeps the thread of a task that stops when it is asked to', async () => {
    const pool = new WorkerPool(1)
    const controller = new AbortController()
    let stop = (_: string): void => undefined
    const stopped = pool.run(() => new Promise<string>((resolve) => (stop = resolve)), { signal: controller.signal })
    await vi.advanceTimersByTimeAsync(0)
    controller.abort()
    stop('half of it')
    expect(await stopped).toBe('half of it')
    await vi.advanceTimersByTimeAsync(2000)
    expect(threads[0]?.terminate).not.toHaveBeenCalled()
    expect(await pool.run(() => Promise.resolve(1))).toBe(1)
    expect(threads).toHaveLength(1)
  })

  test('asks nothing of a thread whose task is over when that is called off later', async () => {
    const pool = new WorkerPool(1)
    const controller = new AbortController()
    await pool.run(() => Promise.resolve(1), { signal: controller.signal })
    controller.abort()
    await vi.advanceTimersByTimeAsync(2000)
    expect([threads[0]?.asked, threads[0]?.terminate.mock.calls.length]).toEqual([[], 0])
  })

  test('watches a task no longer than it lasts', async () => {
    const pool = new WorkerPool(1)
    const task = pool.run(() => new Promise<void>((resolve) => setTimeout(resolve, 1200)), { watched: true })
    await vi.advanceTimersByTimeAsync(3000)
    await task
    const { length } = threads[0]?.asked ?? []
    expect(length).toBeGreaterThan(2)
    expect(new Set(threads[0]?.asked)).toEqual(new Set(['beat']))
    await vi.advanceTimersByTimeAsync(10_000)
    expect(threads[0]?.asked).toHaveLength(length ?? 0)
  })

  test('keeps threads without a task while another one is at work', async () => {
    const pool = new WorkerPool(2)
    void pool.run(endless)
    expect(await pool.run(() => Promise.resolve(1))).toBe(1)
    await vi.advanceTimersByTimeAsync(60_000)
    expect(threads.map(({ terminate }) => terminate.mock.calls.length)).toEqual([0, 0])
  })

  test('ends threads that had no task for half a minute', async () => {
    const pool = new WorkerPool(2)
    const short = (): Promise<void> => new Promise((resolve) => setTimeout(resolve, 10))
    await Promise.all([pool.run(short), pool.run(short), vi.advanceTimersByTimeAsync(20)])
    await vi.advanceTimersByTimeAsync(29_000)
    await Promise.all([pool.run(short), vi.advanceTimersByTimeAsync(20)])
    expect(threads.map(({ terminate }) => terminate.mock.calls.length)).toEqual([0, 0])
    await vi.advanceTimersByTimeAsync(29_000)
    expect(threads.map(({ terminate }) => terminate.mock.calls.length)).toEqual([0, 0])
    await vi.advanceTimersByTimeAsync(2000)
    expect(threads.map(({ terminate }) => terminate.mock.calls.length)).toEqual([1, 1])
    // What comes next has a thread of its own, which is not ended while it is at it.
    const long = pool.run(() => new Promise<string>((resolve) => setTimeout(() => resolve('over'), 100_000)))
    await vi.advanceTimersByTimeAsync(100_001)
    expect(await long).toBe('over')
    expect(threads.map(({ terminate }) => terminate.mock.calls.length)).toEqual([1, 1, 0])
  })
})
