import { expect, test, vi } from 'vitest'
import type { Frame } from './frame'
import { Outlet } from './outlet'

const frameOf = (buffer: ArrayBuffer): Frame => ({ buffer, vertices: 0, spans: 0, fields: [] })
const names = { layers: [], shapes: [] }

test('before there is a renderer the newest frame waits for it, and older ones go back', () => {
  const [release, again] = [vi.fn(), vi.fn()]
  const outlet = new Outlet(release, again)
  const [first, second] = [new ArrayBuffer(1), new ArrayBuffer(2)]
  outlet.put(frameOf(first), names)
  outlet.put(frameOf(second), names)
  expect(release.mock.calls).toEqual([[first]])
  const frame = vi.fn()
  outlet.connect({ frame })
  expect(frame.mock.calls).toEqual([[frameOf(second), names]])
  expect(again).not.toHaveBeenCalled()
})

test('where a renderer has left with the newest frame, the next one asks for it once more', () => {
  const [release, again, frame] = [vi.fn(), vi.fn(), vi.fn()]
  const outlet = new Outlet(release, again)
  const leave = outlet.connect({ frame })
  outlet.put(frameOf(new ArrayBuffer(1)), names)
  expect(again).not.toHaveBeenCalled()
  leave()
  outlet.connect({ frame })
  expect(again).toHaveBeenCalledTimes(1)
})
