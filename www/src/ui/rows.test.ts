import { expect, test } from 'vitest'
import { condensed, seenRows, sorted } from './rows'

test('visible rows, sorted members and condensed strips', () => {
  expect(seenRows(0, 280, 28, 50)).toEqual([0, 14])
  expect(seenRows(2800, 280, 28, 1000)).toEqual([96, 114])
  expect(seenRows(28_000, 280, 28, 50)).toEqual([50, 50])
  expect(seenRows(0, 280, 28, 0)).toEqual([0, 0])
  const values = [3, NaN, 1, 3]
  expect(sorted(4, (member) => values[member] ?? NaN, false)).toEqual([2, 0, 3, 1])
  expect(sorted(4, (member) => values[member] ?? NaN, true)).toEqual([0, 3, 2, 1])
  expect(condensed([1, 2, 3, 4, 5, 6], 3)).toEqual([1.5, 3.5, 5.5])
  expect(condensed([1, 2], 300)).toEqual([1, 2])
})
