import { expect, test } from 'vitest'
import { digits } from './files'

test('files hold numbers in the form that the shell prints', () => {
  for (const [value, text] of [
    [40, '40'],
    [0.1, '0.1'],
    [0.0001, '0.0001'],
    [0.00005, '5e-5'],
    [1.5e-9, '1.5e-9'],
    [-2.5e-7, '-2.5e-7'],
    [0, '0'],
    [-0, '-0'],
    [1e15, '1000000000000000'],
    [1e16, '1e16'],
    [1.25e21, '1.25e21'],
    [12.141590000161472, '12.141590000161472'],
  ] as const) {
    expect(digits(value)).toBe(text)
    expect(Object.is(Number(digits(value)), value)).toBe(true)
  }
})
