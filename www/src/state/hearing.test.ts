import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { Hearing } from './hearing'

beforeEach(() => void vi.useFakeTimers())
afterEach(() => void vi.useRealTimers())

function thread(): { answer: () => void; asked: () => number; deaf: ReturnType<typeof vi.fn>; hearing: Hearing } {
  const waiting: (() => void)[] = []
  let asked = 0
  const deaf = vi.fn()
  const ask = (): Promise<void> => {
    asked += 1
    return new Promise((resolve) => waiting.push(resolve))
  }
  return { answer: () => waiting.shift()?.(), asked: () => asked, deaf, hearing: new Hearing(ask, deaf) }
}

test('a thread that answers within three seconds hears', async () => {
  const { answer, deaf, hearing } = thread()
  hearing.expect()
  await vi.advanceTimersByTimeAsync(2900)
  answer()
  await vi.advanceTimersByTimeAsync(10_000)
  expect(deaf).not.toHaveBeenCalled()
})

test('one that does not is deaf, once', async () => {
  const { deaf, hearing } = thread()
  hearing.expect()
  await vi.advanceTimersByTimeAsync(10_000)
  expect(deaf).toHaveBeenCalledTimes(1)
})

test('what is said while an answer is awaited is asked about next', async () => {
  const { answer, asked, deaf, hearing } = thread()
  hearing.expect()
  hearing.expect()
  hearing.expect()
  expect(asked()).toBe(1)
  answer()
  await vi.advanceTimersByTimeAsync(2900)
  expect([asked(), deaf.mock.calls.length]).toEqual([2, 0])
  await vi.advanceTimersByTimeAsync(200)
  expect(deaf).toHaveBeenCalledTimes(1)
})

test('of a thread that is gone nothing is awaited', async () => {
  const { deaf, hearing } = thread()
  hearing.expect()
  hearing.forget()
  await vi.advanceTimersByTimeAsync(10_000)
  expect(deaf).not.toHaveBeenCalled()
})
