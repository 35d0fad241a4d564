import { expect, test } from 'vitest'
import { amend, begin, commit, redo, undo } from './undo'

test('undo and redo return the same values in order, and stop at both ends', () => {
  const made = [2, 3, 4].reduce(commit, begin(1))
  const undone = undo(undo(made))
  expect(undone.present).toBe(2)
  expect(redo(redo(undone))).toEqual(made)
  expect(undo(undo(undone)).present).toBe(1)
  expect(redo(made)).toBe(made)
})

test('a step after an undo drops what was undone', () => {
  const { past, present, future } = commit(undo([2, 3].reduce(commit, begin(1))), 9)
  expect({ past, present, future }).toEqual({ past: [1, 2], present: 9, future: [] })
})

test('an amended step stays one step', () => {
  const { past, present } = amend(commit(begin(1), 2), 5)
  expect({ past, present }).toEqual({ past: [1], present: 5 })
})

test('the oldest of more than 200 steps are dropped', () => {
  const { past } = Array.from({ length: 300 }, (_, k) => k + 1).reduce(commit, begin(0))
  expect([past.length, past[0], past.at(-1)]).toEqual([200, 100, 299])
})
