import type { GridScene, Moving } from 'forage-lab'
import { expect, test } from 'vitest'
import { straightened } from './aiming'
import { rescale, resizeRobot } from './resizing'

const RIGHT: Moving = { center: [210, 170], radius: 12, velocity: [50, 0] }
const WAYS: Moving = {
  center: [60, 260],
  radius: 10,
  waypoints: [
    [2, 100, 280],
    [5, 160, 320],
  ],
}

const scene = (moving: Moving[]): GridScene => ({
  format: 'forage-scene',
  version: 1,
  name: 'grid',
  title: 'Grid',
  kind: 'grid',
  cell: 20,
  rows: ['..'],
  start: [10, 10],
  moving,
})

test('moving obstacles scale with the cells; without waypoints they keep their first velocity', () => {
  const twice = rescale(scene([RIGHT, WAYS]), 40)
  expect(twice.moving).toEqual([
    { center: [420, 340], radius: 24, velocity: [100, 0] },
    {
      center: [120, 520],
      radius: 20,
      waypoints: [
        [2, 200, 560],
        [5, 320, 640],
      ],
    },
  ])
  expect(straightened(scene([WAYS]), 0).moving).toEqual([{ center: [60, 260], radius: 10, velocity: [20, 10] }])
})

test('start and goal stay in their cells, and a cell size that is no number changes nothing else', () => {
  expect(rescale(scene([]), 40)).toMatchObject({ cell: 40, start: [20, 20] })
  expect(rescale(scene([]), NaN)).toMatchObject({ start: [10, 10] })
})

test('a robot with one side gets the other one as long', () => {
  const square = resizeRobot(scene([]), 'length', 3)
  expect(square.robot).toEqual({ length: 3, width: 3 })
  expect(resizeRobot(square, 'width', 2).robot).toEqual({ length: 3, width: 2 })
})
