import type { GridScene } from 'forage-lab'
import { expect, test } from 'vitest'
import { isBlocked } from '../../scene/cells'
import { tooNear } from './overlap-cells'

const scene: GridScene = {
  format: 'forage-scene',
  version: 1,
  name: 'grid',
  title: 'Grid',
  kind: 'grid',
  cell: 1,
  y_axis: 'down',
  rows: ['...', '.#.', '...'],
  robot: { length: 0.6, width: 0.8 },
}

test('a place is too near to a blocked cell exactly within the robot’s reach, corners rounded', () => {
  expect(isBlocked(scene, { column: 1, row: 1 })).toBe(true)
  expect(tooNear(scene, [0.51, 1.5], 0)).toBe(true)
  expect(tooNear(scene, [0.49, 1.5], 0)).toBe(false)
  const diagonal = 0.5 / Math.SQRT2
  expect(tooNear(scene, [1 - diagonal + 0.01, 1 - diagonal + 0.01], 0)).toBe(true)
  expect(tooNear(scene, [1 - diagonal - 0.01, 1 - diagonal - 0.01], 0)).toBe(false)
  expect(tooNear({ ...scene, robot: {} }, [1.5, 1.5], 0.01)).toBe(true)
  expect(tooNear({ ...scene, robot: {} }, [1.005, 1.5], 0.01)).toBe(false)
})
