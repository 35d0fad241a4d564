import { expect, test } from 'vitest'
import { mark, marksOf, spread } from './dots'

const PLACE = { left: 2, top: 2, right: 1, up: 1 }

/** How opaque the pixels are, row by row. */
function drawn(width: number, height: number, side: number, steps: number[], vertices: number[], place = PLACE): number[][] {
  const grid = { width, height, side }
  const [marks, words] = [new Uint32Array(marksOf(grid)), new Uint32Array(width * height)]
  const used = mark(grid, marks, place, steps, Float32Array.from(vertices))
  spread(grid, marks, used, 0x123456, words)
  expect(words.every((word) => word === 0 || (word & 0xffffff) === 0x123456)).toBe(true)
  return Array.from({ length: height }, (_, row) => [...words.subarray(row * width, (row + 1) * width)].map((word) => word >>> 24))
}

test('a point is a square about it, upwards on the screen', () => {
  expect(drawn(5, 4, 2, [1], [1, 1, 0, 0])).toEqual([
    [0, 0, 255, 255, 0],
    [0, 0, 255, 255, 0],
    [0, 0, 0, 0, 0],
    [0, 0, 0, 0, 0],
  ])
})

test('a step of weights has its opacity, and what lies over each other is more opaque', () => {
  const [, row, below] = drawn(4, 4, 1, [0.5, 0.2], [0.5, 0.5, 0, 0, 0.5, 0.5, 0, 0.49, 1.5, 0.5, 0, 0.5, 1.5, -0.5, 0, 7])
  // 0.5 over 0.5 is 0.75; opacities are told apart to about a hundredth.
  expect((row?.[2] ?? 0) / 255).toBeCloseTo(0.75, 2)
  expect((row?.[3] ?? 0) / 255).toBeCloseTo(0.2, 2)
  expect((below?.[3] ?? 0) / 255).toBeCloseTo(0.2, 2)
})

test('squares overlap as they would one by one', () => {
  const vertices = Array.from({ length: 60 }, (_, at) => [
    ((at * 7) % 23) / 2 - 2,
    ((at * 13) % 19) / 2 - 3,
    0,
    ((at % 6) + 0.5) / 6,
  ]).flat()
  const steps = [0.9, 0.8, 0.7, 0.6, 0.5, 0.4]
  const left = Array.from({ length: 9 }, () => new Array<number>(11).fill(1))
  for (let at = 0; at < vertices.length; at += 4) {
    const [x = 0, y = 0, , weight = 0] = vertices.slice(at, at + 4)
    const [column, row] = [Math.floor(PLACE.left + x - 1.5 + 0.5), Math.floor(PLACE.top - y - 1.5 + 0.5)]
    for (let dy = 0; dy < 3; dy += 1)
      for (let dx = 0; dx < 3; dx += 1) {
        const line = left[row + dy]
        if (line?.[column + dx] !== undefined) line[column + dx] = (line[column + dx] ?? 1) * (1 - (steps[Math.floor(weight * 6)] ?? 0))
      }
  }
  const found = drawn(11, 9, 3, steps, vertices)
  for (const [row, line] of found.entries())
    for (const [column, opacity] of line.entries()) expect(Math.abs(opacity / 255 - 1 + (left[row]?.[column] ?? 1))).toBeLessThan(0.03)
})

test('what lies on the rim is cut off, what lies beyond or nowhere is left out', () => {
  const vertices = [0, 0, 0, 0, 50, 0, 0, 0, 0, -50, 0, 0, NaN, 1, 0, 0]
  expect(drawn(3, 3, 3, [1], vertices, { left: 0, top: 0, right: 1, up: 1 })).toEqual([
    [255, 255, 0],
    [255, 255, 0],
    [0, 0, 0],
  ])
})
