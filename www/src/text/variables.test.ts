import { expect, test } from 'vitest'
import { changes } from './variables'

test('changes are listed by where they are', () => {
  const before = { x: [1, 2], cost: 3, name: 'a', gone: true, deep: { list: [{ y: 0.5 }] } }
  const now = { x: [1, 2.5, 4], cost: 3, name: 'b', deep: { list: [{ y: 0.5 }] }, best: null }
  expect(changes(before, now)).toEqual({
    changed: [
      { path: 'x[1]', before: '2', now: '2.5' },
      { path: 'x[2]', before: undefined, now: '4' },
      { path: 'name', before: '"a"', now: '"b"' },
      { path: 'best', before: undefined, now: 'null' },
      { path: 'gone', before: 'true', now: undefined },
    ],
    same: 3,
  })
})

test('numbers that differ look different, and what is the same number is no change', () => {
  expect(changes({ a: 1.00000001, b: Number.NaN }, { a: 1.00000002, b: Number.NaN })).toEqual({
    changed: [{ path: 'a', before: '1.00000001', now: '1.00000002' }],
    same: 1,
  })
  expect(changes(undefined, { a: 1 }).changed).toEqual([{ path: 'a', before: undefined, now: '1' }])
})
