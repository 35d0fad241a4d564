import { expect, test } from 'vitest'
import { Latest } from './latest-request'

const passed = (): Promise<void> => new Promise((resolve) => setTimeout(resolve))

test('of requests that come while one is answered only the newest is sent', async () => {
  const sent: number[] = []
  const answers: (() => void)[] = []
  const latest = new Latest<number>((wanted) => {
    sent.push(wanted)
    return new Promise<void>((resolve) => answers.push(resolve))
  })
  for (const wanted of [1, 2, 3]) latest.want(wanted)
  expect(sent).toEqual([1])
  answers.shift()?.()
  await passed()
  expect(sent).toEqual([1, 3])
  answers.shift()?.()
  await passed()
  latest.want(4)
  expect(sent).toEqual([1, 3, 4])
})

test('after a request that fails, the next one is sent', async () => {
  const sent: number[] = []
  const failed = new Error('failed')
  const seen: unknown[] = []
  const note = (reason: unknown): number => seen.push(reason)
  process.on('unhandledRejection', note)
  const latest = new Latest<number>((wanted) => {
    sent.push(wanted)
    return Promise.reject(failed)
  })
  latest.want(1)
  await passed()
  latest.want(2)
  await passed()
  process.off('unhandledRejection', note)
  expect(sent).toEqual([1, 2])
})
