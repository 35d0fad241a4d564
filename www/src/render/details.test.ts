import { expect, test } from 'vitest'
import { detailsOf, markAt } from './details'
import { PLAIN } from './looks'

const marks = [
  { role: 'before', shape: 'points', vertices: [[0, 0, 0]] },
  {
    role: 'inertia',
    shape: 'segments',
    vertices: [
      [0, 0, 0],
      [10, 0, 0],
      [50, 0, 0],
      [50, 10, 0],
    ],
  },
  {
    role: 'after',
    shape: 'polyline',
    vertices: [
      [0, 30, 0],
      [10, 30, 0],
      [10, 40, 0],
    ],
  },
] as const
const all = marks.map(({ role, shape, vertices }) => ({
  role,
  shape,
  vertices: vertices.map((vertex): [number, number, number] => [...vertex]),
}))
/** A unit a pixel, with (0, 0) in the middle. */
const [view, size] = [
  { x: 0, y: 0, scale: 1 },
  { width: 200, height: 200 },
]

test('what is pointed at is the nearest mark, if one is near', () => {
  const details = detailsOf(all, () => PLAIN, null)
  const at = (x: number, y: number): string | null => markAt(details, view, size, [100 + x, 100 - y])
  expect(at(0, 1)).toBe('before')
  expect(at(7, 2)).toBe('inertia')
  expect(at(52, 6)).toBe('inertia')
  // Between two arrows there is none.
  expect(at(30, 0)).toBeNull()
  expect(at(12, 36)).toBe('after')
  expect(at(30, 60)).toBeNull()
})

test('one layer stands out, and the others step back', () => {
  const [before, inertia] = detailsOf(all, () => PLAIN, 'inertia')
  const [plain] = detailsOf(all, () => PLAIN, null)
  expect(inertia?.look.width).toBeGreaterThan(plain?.look.width ?? Infinity)
  expect(before?.look.opacity[0]).toBeLessThan(0.3)
  expect(plain?.look.opacity[0]).toBeGreaterThan(0.8)
})
