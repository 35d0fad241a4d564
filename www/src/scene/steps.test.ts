import { expect, test } from 'vitest'
import { placeAt, Walk } from './steps'

/** Two ants: one arrives after three steps, the other is stuck after one. */
const walk = Walk.of([Float32Array.of(0, 0, 0, 1, 2, 0, 0, 1, 4, 0, 0, 1, 4, 2, 0, 1), Float32Array.of(0, 0, 0, 0, 0, 2, 0, 0)])

test('an ant moves straight between its steps and stays at its end', () => {
  const [ant] = walk.ants
  if (!ant) throw new Error('no ant')
  expect(placeAt(ant, 1)).toEqual([2, 0])
  expect(placeAt(ant, 1.5)).toEqual([3, 0])
  expect(placeAt(ant, 2.25)).toEqual([4, 0.5])
  expect(placeAt(ant, 12)).toEqual([4, 2])
})

test('ants are counted as walking, arrived and stuck', () => {
  expect([walk.end, walk.stride]).toEqual([3, 2])
  expect([0, 1, 2, 3].map((step) => walk.counts(step))).toEqual([
    { walking: 2, arrived: 0, stuck: 0 },
    { walking: 1, arrived: 0, stuck: 1 },
    { walking: 1, arrived: 0, stuck: 1 },
    { walking: 0, arrived: 1, stuck: 1 },
  ])
})
