import { expect, test } from 'vitest'
import { digitsFor, probability } from './words'

test('close values keep the digits that differ, and tiny probabilities are not shown as zero', () => {
  expect(digitsFor([12.1459, 12.1469])).toBeGreaterThanOrEqual(8)
  expect(digitsFor([1, 100])).toBe(5)
  expect(probability(1.234e-40)).toBe('1.2×10⁻⁴⁰')
  expect(probability(0.0123)).toBe('0.0123')
})
