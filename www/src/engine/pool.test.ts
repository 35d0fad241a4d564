import { expect, test, vi } from 'vitest'
import { useHost } from './host'
import { Aborted, WorkerPool } from './pool'

const noThreads = (): Worker => {
  throw new Error('no threads here')
}

/** A thread that does nothing by itself. */
class Idle extends EventTarget {
  onerror = null
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
