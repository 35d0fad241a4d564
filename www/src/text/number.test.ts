import { expect, test } from 'vitest'
import { exactly, number, percent } from './number'

test('a number is shown with four significant digits', () => {
  expect(number(12.1415926)).toBe('12.14')
  expect(number(-0.03)).toBe('−0.03000')
  expect(number(75_000)).toBe('75\u202f000')
  expect(number(3.2123e-12)).toBe('3.21×10⁻¹²')
  expect(number(999_999.7)).toBe('1\u202f000\u202f000')
  expect(number(0)).toBe('0')
  expect(number(Number.NaN)).toBe('–')
  expect(number(-Infinity)).toBe('−∞')
})

test('a parameter’s value keeps all its digits', () => {
  expect(exactly(1.49618)).toBe('1.49618')
  expect(exactly(1e-7)).toBe('1×10⁻⁷')
  expect(exactly(100_000)).toBe('100\u202f000')
  expect(exactly(true)).toBe('true')
})

test('a gap is shown in per cent, also when it is tiny', () => {
  expect(percent(0.0015)).toBe('0.15 %')
  expect(percent(0.0015, true)).toBe('+0.15 %')
  expect(percent(-0.02)).toBe('−2.00 %')
  expect(percent(3.2e-8)).toBe('3×10⁻⁶ %')
})
