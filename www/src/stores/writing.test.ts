import { expect, test } from 'vitest'
import { numbers, placeIn } from './writing.svelte'

test('sides are read as one number or one for each variable', () => {
  expect(numbers('-5')).toBe(-5)
  expect(numbers(' −5, 0.5;1e3 ')).toEqual([-5, 0.5, 1000])
  for (const text of ['', ' , ', 'a', '1 2 b', 'Infinity']) expect(numbers(text)).toBeNull()
})

test('the place of what is wrong in a formula is the first number of its message', () => {
  expect(placeIn({ field: 'expression', message: 'character 9: the formula ends here' })).toBe(8)
  expect(placeIn({ field: 'bounds.max[1]', message: 'character 9' })).toBeNull()
})
