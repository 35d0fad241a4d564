import { expect, test } from 'vitest'
import type { Layer } from 'forage-lab'
import { anchorsOf, movedTo, orderOf, pointsOf } from './anchors'
import type { Layers } from './frame'

const layer = (role: string, glyph?: string): Layer => ({ role, look: { glyph } }) as unknown as Layer

/** Layers by number with a piece each, in this order. */
function frameOf(pieces: readonly [layer: number, ...vertices: number[]][]): Layers {
  const vertices = pieces.flatMap(([, ...numbers]) => numbers)
  const spans = pieces.length * 4
  const buffer = new ArrayBuffer(4 * (vertices.length + spans))
  new Float32Array(buffer, 0, vertices.length).set(vertices)
  let first = 0
  const table = pieces.flatMap(([of, ...numbers]) => {
    const row = [of, 0, first, numbers.length / 4]
    first += numbers.length / 4
    return row
  })
  new Uint32Array(buffer, 4 * vertices.length, spans).set(table)
  return { buffer, vertices: vertices.length, spans }
}

const names = { shapes: [], layers: [layer('ants'), layer('moving', 'disc'), layer('order', 'number')] }

test('vertices of a form are found over all pieces of their layer', () => {
  const frame = frameOf([
    [1, 1, 2, 0, 0.5],
    [0, 9, 9, 9, 9],
    [1, 3, 4, 0, 0.5],
    [2, 0, 0, 0, 1, 5, 5, 0, 0],
  ])
  const anchors = anchorsOf(frame, names)
  expect(pointsOf(anchors.disc)).toEqual([
    [1, 2],
    [3, 4],
  ])
  expect(movedTo(anchors, 2)).toEqual(pointsOf(anchors.disc))
  expect(orderOf(anchors, 2)).toEqual([1, 0])
  expect(anchors.event).toHaveLength(0)
  // They outlast the frame.
  new Uint8Array(frame.buffer).fill(0)
  expect(anchors.disc[0]).toBe(1)
})

test('of another number of obstacles or stops, and of a tour that does not begin, nothing is known', () => {
  const anchors = anchorsOf(
    frameOf([
      [1, 1, 2, 0, 0.5],
      [2, 0, 0, 0, -1],
    ]),
    names,
  )
  expect(movedTo(anchors, 2)).toBeNull()
  expect(movedTo(anchors, 0)).toBeNull()
  expect(orderOf(anchors, 1)).toBeNull()
  expect(orderOf(anchors, 2)).toBeNull()
})
