import { expect, test } from 'vitest'
import { Buffers } from './buffers'

test('no more buffers are away than there may be', () => {
  const buffers = new Buffers(2)
  const [first, second] = [0, 1].map(() => {
    expect(buffers.ready).toBe(true)
    return buffers.take(100)
  }) as [ArrayBuffer, ArrayBuffer]
  expect(buffers.ready).toBe(false)
  buffers.giveBack(first)
  expect(buffers.ready).toBe(true)
  buffers.giveBack(second)
  // One that was never taken makes no room for more.
  buffers.giveBack(new ArrayBuffer(1))
  for (let k = 0; k < 2; k += 1) buffers.take(1)
  expect(buffers.ready).toBe(false)
})

test('a buffer that came back is used again if it is large enough; a new one has a quarter to spare', () => {
  const buffers = new Buffers(3)
  const first = buffers.take(101)
  expect(first.byteLength).toBe(127)
  buffers.giveBack(first)
  expect(buffers.take(127)).toBe(first)
  buffers.giveBack(first)
  const larger = buffers.take(128)
  expect([larger === first, larger.byteLength]).toEqual([false, 160])
})
