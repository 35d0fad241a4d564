import { expect, test } from 'vitest'
import { decades, natural, range } from './scale'

test('the scale of a chart fits its values', () => {
  const decay = Array.from({ length: 50 }, (_, k) => 10 ** -k)
  const iterations = decay.map((_, k) => k)
  expect(natural({ iterations, values: [decay] })).toBe('log')
  expect(natural({ iterations, values: [decay.map((y) => y - 1e-3)] })).toBe('linear')
  const flat = iterations.map((k) => 13 - k / 50)
  expect(natural({ iterations, values: [flat, flat.map(() => 120)] })).toBe('near')
  expect(natural({ iterations, values: [flat.map(() => null), flat.map((y) => 40 * y)] }), 'nothing is found yet').toBe('linear')
  const [low, high] = range({ iterations, values: [flat, flat.map(() => 120)] }, 'near', 11.9)
  expect(low).toBeLessThan(11.9)
  expect(high).toBeLessThan(20)
  expect(high).toBeGreaterThan(12.02)
  const rounded = [iterations.map((k) => 26.5 + (k % 2) * 1e-14)]
  const [bottom, top] = range({ iterations, values: rounded }, 'linear', null)
  expect(top - bottom, 'rounding is not magnified').toBeGreaterThan(1)
  expect(decades([1e-16, 30], 6).length).toBeLessThanOrEqual(6)
})
