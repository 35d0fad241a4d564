import type { Drive, Motion } from 'forage-lab'
import { expect, test } from 'vitest'
import { Swing } from './trajectory'
import { Track } from './track'

const drive = { columns: ['time', 'x', 'y', 'heading'], rows: Float64Array.of(0, 0, 0, 3, 2, 4, 2, -3, 3, 4, 6, -3) } as unknown as Drive
const motion = {
  columns: ['time', 'q1', 'q2', 'q3', 'q4', 'q5', 'q6', 'x', 'y', 'z'],
  rows: Float64Array.of(0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 4, 40, -20, 0, 0, 0, 8, 5, 2, 1),
} as unknown as Motion

test('a robot goes straight between two rows and turns the shorter way', () => {
  const track = new Track(drive)
  expect(track.end).toBe(3)
  expect(track.at(1)).toMatchObject({ x: 2, y: 1 })
  expect(track.at(1).heading).toBeCloseTo(Math.PI, 9)
  expect(track.at(2.5)).toEqual({ x: 4, y: 4, heading: -3 })
})

test('before its first and after its last row a robot stands', () => {
  const track = new Track(drive)
  expect(track.at(-1)).toEqual({ x: 0, y: 0, heading: 3 })
  expect(track.at(99)).toEqual({ x: 4, y: 6, heading: -3 })
})

test('an arm’s joints and tip move evenly between two rows', () => {
  const swing = new Swing(motion)
  expect(swing.postureAt(1)).toEqual([10, -5, 0, 0, 0, 2])
  expect(swing.tipAt(2)).toEqual([3, 2, 2])
  expect([swing.neighbour(0, true), swing.neighbour(3, true), swing.neighbour(4, false), swing.neighbour(1, false)]).toEqual([4, 4, 0, 0])
})

test('rows are written as CSV with all digits', () => {
  expect(new Track(drive).csv()).toBe('time,x,y,heading\n0,0,0,3\n2,4,2,-3\n3,4,6,-3\n')
})
