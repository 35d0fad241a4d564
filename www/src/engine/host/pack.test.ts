import { expect, test } from 'vitest'
import { pack } from './pack'

test('packing leaves fields out and keeps the order of the rest', () => {
  const vertices = Float32Array.from({ length: 4 * 9 }, (_, at) => at)
  const spans = Uint32Array.from([1, 0, 0, 2, 5, 3, 2, 4, 2, 1, 6, 3])
  const { buffer, vertices: floats, spans: rows } = pack(vertices, spans, 3, (bytes) => new ArrayBuffer(bytes + 16))
  expect([...new Float32Array(buffer, 0, floats)]).toEqual([...vertices.subarray(0, 8), ...vertices.subarray(24, 36)])
  expect([...new Uint32Array(buffer, floats * 4, rows)]).toEqual([1, 0, 0, 2, 2, 1, 2, 3])
})

test('without fields all of it is copied as it is, into a buffer that is exactly as large', () => {
  const vertices = Float32Array.from({ length: 8 }, (_, at) => at / 3)
  const spans = Uint32Array.from([1, 0, 0, 1, 2, 1, 1, 1])
  const asked: number[] = []
  const {
    buffer,
    vertices: floats,
    spans: rows,
  } = pack(vertices, spans, 3, (bytes) => {
    asked.push(bytes)
    return new ArrayBuffer(bytes)
  })
  expect([asked, floats, rows]).toEqual([[64], 8, 8])
  expect([...new Float32Array(buffer, 0, floats)]).toEqual([...vertices])
  expect([...new Uint32Array(buffer, floats * 4)]).toEqual([...spans])
})
