import type { DiscsScene, GridScene, Point, TourScene } from 'forage-lab'
import { expect, test } from 'vitest'
import { add, blamed, edited, move, remove, resize } from './edits'
import { withStops } from './stops'

const discs: DiscsScene = {
  format: 'forage-scene',
  version: 1,
  name: 'discs',
  title: 'Discs',
  note: 'published',
  kind: 'discs',
  bounds: { min: [0, 0], max: [9, 9] },
  start: [1, 1],
  goal: [8, 8],
  discs: [{ center: [4, 4], radius: 1 }],
}
const grid: GridScene = {
  format: 'forage-scene',
  version: 1,
  name: 'grid',
  title: 'Grid',
  kind: 'grid',
  cell: 10,
  rows: ['...', '...'],
  start: [5, 5],
  stops: [[15, 5]],
}

test('the ends of a grid’s path stay inside, those of a plane need not', () => {
  expect(move(grid, { kind: 'start' }, [-4, 99])).toMatchObject({ start: [0, 20] })
  expect(move(grid, { kind: 'stop', index: 0 }, [99, -4])).toMatchObject({ stops: [[30, 0]] })
  expect(move(discs, { kind: 'goal' }, [-4, 99])).toMatchObject({ goal: [-4, 99] })
})

test('numbers of edits have at most four decimals', () => {
  expect(move(discs, { kind: 'disc', index: 0 }, [1 / 3, 2 / 3])).toMatchObject({ discs: [{ center: [0.3333, 0.6667] }] })
  expect(resize(discs, 0, 1 / 3).discs[0]?.radius).toBe(0.3333)
  expect(add(discs, { center: [1 / 3, 0], radius: 0.5 }).discs).toHaveLength(2)
})

test('only what is there is removed', () => {
  expect(remove(discs, { kind: 'disc', index: 0 })).toMatchObject({ discs: [] })
  expect(remove(discs, { kind: 'start' })).toBe(discs)
  expect(remove(discs, null)).toBe(discs)
})

test('an edited scene no longer has what was published about it', () => {
  expect(edited(discs)).not.toHaveProperty('note')
  expect(edited(discs).discs).toBe(discs.discs)
})

test.each([
  ['discs[2].radius', { kind: 'disc', index: 2 }],
  ['points[11][0]', { kind: 'stop', index: 11 }],
  ['moving[0].velocity[1]', { kind: 'moving', index: 0 }],
  ['goal[1]', { kind: 'goal' }],
  ['arm.base[2]', { kind: 'base' }],
  ['population', null],
])('a refusal of %s selects the object it names', (field, selection) => {
  expect(blamed(field)).toEqual(selection)
})

const tour: TourScene = {
  format: 'forage-scene',
  version: 1,
  kind: 'tour',
  name: 't',
  title: 'T',
  points: [
    [0, 0],
    [1, 0],
    [2, 0],
    [3, 0],
  ],
  fixed: [
    [0, 3],
    [1, 2],
  ],
}

test('fixed edges follow their stops, and go with them', () => {
  const fixed = (by: (stops: Point[]) => Point[]) => withStops(tour, by).fixed
  expect(fixed((stops) => stops.filter((_, at) => at !== 1))).toEqual([[0, 2]])
  expect(fixed((stops) => stops.filter((_, at) => at !== 0))).toEqual([[0, 1]])
  expect(fixed((stops) => stops.with(0, [9, 9]))).toEqual(tour.fixed)
  expect(fixed((stops) => [...stops, [4, 0]])).toEqual(tour.fixed)
})
