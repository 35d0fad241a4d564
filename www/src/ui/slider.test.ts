import { expect, test } from 'vitest'
import { slider, typed } from './slider'

test('typed text is a number only in plain notation', () => {
  expect(typed(' 1e-3 ')).toBe(0.001)
  expect(typed('−2')).toBe(-2)
  expect(typed('.5')).toBe(0.5)
  for (const text of ['', 'abc', '1,5', '1 000', '0x10', 'NaN', 'Infinity', '1e']) expect(typed(text)).toBeUndefined()
})

test('a logarithmic slider reaches both ends and maps values back', () => {
  const population = slider({
    name: 'population',
    symbol: 'N',
    title: '',
    help: '',
    type: 'integer',
    default: 60,
    defaults: {},
    kinds: [],
    min: 1,
    max: 100_000,
    soft_min: 2,
    soft_max: 2000,
    logarithmic: true,
  })
  if (!population) throw new Error('no slider')
  expect(population.value(population.min)).toBe(2)
  expect(population.value(population.max)).toBe(2000)
  expect(population.position(100_000)).toBe(population.max)
  for (let position = 0; position <= population.max; position += 1) expect(Number.isInteger(population.value(position))).toBe(true)
  expect(Math.abs(population.value(Math.round(population.position(150))) / 150 - 1)).toBeLessThan(0.05)
})
