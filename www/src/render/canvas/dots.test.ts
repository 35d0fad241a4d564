import { expect, test } from 'vitest'
import { cover, type Opacities } from './dots'

const sheet = (width: number, height: number): Opacities => ({ width, height, pixels: new Uint8Array(width * height) })
const place = { left: 2, top: 2, right: 1, up: 1 }

test('a point covers a square about it, upwards on the screen', () => {
  const found = sheet(5, 4)
  cover(found, place, 2, [1], Float32Array.of(1, 1, 0, 0))
  const rows = [0, 1, 2, 3].map((row) => [...found.pixels.subarray(5 * row, 5 * row + 5)])
  expect(rows).toEqual([
    [0, 0, 255, 255, 0],
    [0, 0, 255, 255, 0],
    [0, 0, 0, 0, 0],
    [0, 0, 0, 0, 0],
  ])
})

test('a step of weights has its opacity, and what lies over each other is more opaque', () => {
  const found = sheet(4, 4)
  cover(found, place, 1, [0.5, 0.2], Float32Array.of(0.5, 0.5, 0, 0, 0.5, 0.5, 0, 0.49, 1.5, 0.5, 0, 0.5, 1.5, -0.5, 0, 7))
  // 0.5 over 0.5 is 0.75.
  expect(found.pixels[6]).toBe(Math.round(128 + 127 * 0.5))
  expect(found.pixels[7]).toBe(51)
  expect(found.pixels[11]).toBe(51)
})

test('what lies on the rim is cut off, what lies beyond or nowhere is left out', () => {
  const found = sheet(3, 3)
  cover(found, { left: 0, top: 0, right: 1, up: 1 }, 3, [1], Float32Array.of(0, 0, 0, 0, 50, 0, 0, 0, 0, -50, 0, 0, NaN, 1, 0, 0))
  expect([...found.pixels]).toEqual([255, 255, 0, 255, 255, 0, 0, 0, 0])
})
