import type { DiscsScene } from 'forage-lab'
import { expect, test } from 'vitest'
import { hit } from './hit'
import { fit as fitted, toScreen } from './view'

const scene: DiscsScene = {
  format: 'forage-scene',
  version: 1,
  name: 'discs',
  title: 'Discs',
  kind: 'discs',
  bounds: { min: [0, 0], max: [100, 100] },
  start: [5, 5],
  goal: [95, 95],
  discs: [
    { center: [50, 50], radius: 30 },
    { center: [55, 50], radius: 2 },
  ],
}
const SIZE = { width: 600, height: 600 }
const view = fitted(scene.bounds, SIZE, [50, 50])
const at = (x: number, y: number, selected: number | null = null) =>
  hit(scene, view, SIZE, toScreen(view, SIZE, [x, y]), selected === null ? null : { kind: 'disc', index: selected }, false, false)

test('ends win over discs, small discs over large ones, rims over what they surround', () => {
  expect(at(5, 5)).toEqual({ kind: 'start' })
  expect(at(95, 95)).toEqual({ kind: 'goal' })
  expect(at(55, 50)).toEqual({ kind: 'disc', index: 1 })
  expect(at(40, 50)).toEqual({ kind: 'disc', index: 0 })
  expect(at(50, 80)).toEqual({ kind: 'rim', index: 0 })
  expect(at(5, 95)).toBeNull()
})

test('the handle of a selected disc resizes it', () => {
  expect(at(57, 50)).toEqual({ kind: 'disc', index: 1 })
  expect(at(57, 50, 1)).toEqual({ kind: 'rim', index: 1 })
})
