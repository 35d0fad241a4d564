import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { Watchdog } from './watchdog'

beforeEach(() => void vi.useFakeTimers())
afterEach(() => void vi.useRealTimers())

function thread(): { answer: () => void; asked: () => number; onUnresponsive: ReturnType<typeof vi.fn>; watchdog: Watchdog } {
  const waiting: (() => void)[] = []
  let asked = 0
  const onUnresponsive = vi.fn()
  const ask = (): Promise<void> => {
    asked += 1
    return new Promise((resolve) => waiting.push(resolve))
  }
  return { answer: () => waiting.shift()?.(), asked: () => asked, onUnresponsive, watchdog: new Watchdog(ask, onUnresponsive) }
}

test('a thread that answers within three seconds is responsive', async () => {
  const { answer, onUnresponsive, watchdog } = thread()
  watchdog.expect()
  await vi.advanceTimersByTimeAsync(2900)
  answer()
  await vi.advanceTimersByTimeAsync(10_000)
  expect(onUnresponsive).not.toHaveBeenCalled()
})

test('one that does not is unresponsive, once', async () => {
  const { onUnresponsive, watchdog } = thread()
  watchdog.expect()
  await vi.advanceTimersByTimeAsync(10_000)
  expect(onUnresponsive).toHaveBeenCalledTimes(1)
})

test('what is sent while an answer is awaited is asked about next', async () => {
  const { answer, asked, onUnresponsive, watchdog } = thread()
  watchdog.expect()
  watchdog.expect()
  watchdog.expect()
  expect(asked()).toBe(1)
  answer()
  await vi.advanceTimersByTimeAsync(2900)
  expect([asked(), onUnresponsive.mock.calls.length]).toEqual([2, 0])
  await vi.advanceTimersByTimeAsync(200)
  expect(onUnresponsive).toHaveBeenCalledTimes(1)
})

test('of a thread that is gone nothing is awaited', async () => {
  const { onUnresponsive, watchdog } = thread()
  watchdog.expect()
  watchdog.stop()
  await vi.advanceTimersByTimeAsync(10_000)
  expect(onUnresponsive).not.toHaveBeenCalled()
})

test('what was asked before a thread was given up says nothing of the next', async () => {
  const { answer, asked, onUnresponsive, watchdog } = thread()
  watchdog.expect()
  watchdog.stop()
  watchdog.expect()
  // The old answer comes late: the new one is awaited still.
  answer()
  await vi.advanceTimersByTimeAsync(3100)
  expect([asked(), onUnresponsive.mock.calls.length]).toEqual([2, 1])
})

test('without more that is sent a thread is asked once', async () => {
  const { answer, asked, watchdog } = thread()
  watchdog.expect()
  answer()
  await vi.advanceTimersByTimeAsync(10_000)
  expect(asked()).toBe(1)
})
