import { expect, test } from '@playwright/test'
import { curves, pointAt, sample } from '../src/panels/chart/curves'
import { decades, natural, range } from '../src/panels/chart/scale'
import { exactly, number, percent } from '../src/panels/format'
import { fill } from '../src/panels/math/fill'
import { slider, typed } from '../src/panels/parameters/slider'

/* What panels make of numbers; nothing here needs a browser. */

const slot = (name: string): string => `<mtext>@${name}@</mtext>`

test('a reading has the same number of digits whatever its size', () => {
  expect(number(12.1415926)).toBe('12.14')
  expect(number(-0.03)).toBe('−0.03000')
  expect(number(75_000)).toBe('75\u202f000')
  expect(number(3.2123e-12)).toBe('3.21×10⁻¹²')
  expect(number(999_999.7)).toBe('1\u202f000\u202f000')
  expect(number(0)).toBe('0')
  expect(number(Number.NaN)).toBe('–')
  expect(number(-Infinity)).toBe('−∞')
})

test('a parameter’s value loses no digit', () => {
  expect(exactly(1.49618)).toBe('1.49618')
  expect(exactly(1e-7)).toBe('1×10⁻⁷')
  expect(exactly(100_000)).toBe('100\u202f000')
  expect(exactly(true)).toBe('true')
})

test('a gap is told in per cent, small ones too', () => {
  expect(percent(0.0015)).toBe('0.15 %')
  expect(percent(0.0015, true)).toBe('+0.15 %')
  expect(percent(-0.02)).toBe('−2.00 %')
  expect(percent(3.2e-8)).toBe('3×10⁻⁶ %')
})

test('numbers are put into a formula, a negative one in parentheses where it follows something', () => {
  const values = { x: -2.5, y: 0.125, tiny: 1.5e-9 }
  expect(fill(`<mrow>${slot('y')}</mrow>`, values)).toBe('<mrow><mn>0.125</mn></mrow>')
  expect(fill(`<mrow>${slot('y')}<mo>−</mo>${slot('x')}</mrow>`, values)).toContain('<mo>−</mo><mrow><mo stretchy="false">(</mo>')
  expect(fill(`<mrow><mi>v</mi><mo>=</mo>${slot('x')}</mrow>`, values)).not.toContain('(')
  expect(fill(`<mrow><mi>v</mi><mo form="infix">⋅</mo></mrow><mrow>${slot('x')}</mrow>`, values)).toContain('(')
  expect(fill(`<mrow>${slot('tiny')}</mrow>`, values)).toContain('<mn>1.50</mn><mo>⋅</mo><mn>10⁻⁹</mn>')
  expect(fill(slot('unknown'), values)).toBe('<mtext>□</mtext>')
})

test('what is typed is a number or it isn’t; nothing is guessed', () => {
  expect(typed(' 1e-3 ')).toBe(0.001)
  expect(typed('−2')).toBe(-2)
  expect(typed('.5')).toBe(0.5)
  for (const text of ['', 'abc', '1,5', '1 000', '0x10', 'NaN', 'Infinity', '1e']) expect(typed(text)).toBeUndefined()
})

test('a logarithmic slider reaches both its ends and finds its way back from any value', () => {
  const population = slider({
    name: 'population', symbol: 'N', title: '', help: '', type: 'integer', default: 60, defaults: {}, kinds: [],
    min: 1, max: 100_000, soft_min: 2, soft_max: 2000, logarithmic: true,
  })
  if (!population) throw new Error('no slider')
  expect(population.value(population.min)).toBe(2)
  expect(population.value(population.max)).toBe(2000)
  expect(population.position(100_000)).toBe(population.max)
  for (let position = 0; position <= population.max; position += 1) expect(Number.isInteger(population.value(position))).toBe(true)
  expect(Math.abs(population.value(Math.round(population.position(150))) / 150 - 1)).toBeLessThan(0.05)
})

test('curves keep their first and last point however long they are', () => {
  const count = 10_001
  const long = curves(
    { columns: ['a', 'b'], iterations: Array.from({ length: count }, (_, k) => k), rows: Array.from({ length: 2 * count }, (_, at) => at) },
    ['b', 'missing'],
  )
  expect(long.iterations.length).toBeLessThan(2000)
  expect(long.iterations[0]).toBe(0)
  expect(long.iterations.at(-1)).toBe(count - 1)
  expect(long.values[0]?.at(-1)).toBe(2 * count - 1)
  expect(long.values[1]?.every((value) => value === null)).toBe(true)
  expect(long.iterations[pointAt(long, 5003)]).toBeLessThanOrEqual(5003)
  expect(long.iterations[pointAt(long, 5003) + 1]).toBeGreaterThan(5003)
  expect(sample(count, 10)).toHaveLength(10)
  expect(sample(3, 10)).toEqual([0, 1, 2])
})

test('the chart’s scale follows the values', () => {
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
  expect(decades([1e-16, 30], 6).length).toBeLessThanOrEqual(6)
})
