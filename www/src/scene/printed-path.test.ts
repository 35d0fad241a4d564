import { expect, test } from 'vitest'
import type { GridScene } from 'forage-lab'
import { lengthOf, printedPath } from './printed-path'

const scene = {
  format: 'forage-scene',
  version: 1,
  kind: 'grid',
  name: 'printed',
  title: 'Printed',
  cell: 2,
  rows: ['...', '...'],
  start: [1, 1],
  goal: [5, 3],
  published: { path_cells: [0, 1, 5] },
} satisfies GridScene

test('the printed cells are a path through their centres, whichever way y goes', () => {
  const path = [
    [1, 1],
    [3, 1],
    [5, 3],
  ]
  expect(printedPath(scene)?.path).toEqual(path)
  expect(printedPath({ ...scene, y_axis: 'up' })?.path).toEqual(path)
  expect(lengthOf(printedPath(scene)?.path ?? [])).toBe(2 + Math.sqrt(8))
})

test('what names no cells is no path', () => {
  for (const path_cells of [[0, 6], [-1], [0.5], ['0'], [], 'none']) expect(printedPath({ ...scene, published: { path_cells } })).toBeNull()
  expect(printedPath({ ...scene, published: undefined as never })).toBeNull()
})
