import { expect, test } from 'vitest'
import { extent } from './extent'

test('a timeline grows while the end is open, and closes there', () => {
  const open = { limit: 900 }
  expect([0, 99, 100, 205, 500, 899].map((furthest) => extent(open, furthest))).toEqual([100, 100, 200, 400, 800, 900])
  expect(extent({ limit: 900, end: 205 }, 205)).toBe(205)
  expect(extent({ limit: 500, end: 500 }, 0)).toBe(500)
  expect(extent({ limit: 20 }, 0)).toBe(20)
})
