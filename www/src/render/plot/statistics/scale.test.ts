import { expect, test } from 'vitest'
import { linear, logarithmic } from './scale'

test('an axis contains every value, and a logarithmic one also zero', () => {
  const values = [0, 3e-9, 2, 40]
  const log = logarithmic(values, 'value')
  for (const value of values) {
    expect(log.place(value)).toBeGreaterThanOrEqual(log.range[0])
    expect(log.place(value)).toBeLessThanOrEqual(log.range[1])
  }
  const splits = log.splits?.(20) ?? []
  expect(log.label(splits[0] ?? NaN, 1)).toBe('0')
  expect(splits.length).toBeGreaterThan(2)
  expect(splits.length).toBeLessThan(20)
  expect(log.splits?.(4).length).toBeLessThanOrEqual(5)
  // Within one decade there is no power of ten.
  expect((logarithmic([3.1, 3.4], 'value').splits?.(5) ?? []).length).toBeGreaterThan(1)
  const gaps = linear([0.001, 0.02], 'gap')
  expect(gaps.place(0.02)).toBe(2)
  expect(gaps.label(1.5, 0.5)).toBe('1.5 %')
})
