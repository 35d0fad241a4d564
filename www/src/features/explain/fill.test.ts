import { expect, test } from 'vitest'
import { fill } from './fill'

const slot = (name: string): string => `<mtext>@${name}@</mtext>`

test('numbers replace the slots of a formula; a negative one that follows something gets parentheses', () => {
  const values = { x: -2.5, y: 0.125, tiny: 1.5e-9 }
  expect(fill(`<mrow>${slot('y')}</mrow>`, values)).toBe('<mrow><mn>0.125</mn></mrow>')
  expect(fill(`<mrow>${slot('y')}<mo>−</mo>${slot('x')}</mrow>`, values)).toContain('<mo>−</mo><mrow><mo stretchy="false">(</mo>')
  expect(fill(`<mrow><mi>v</mi><mo>=</mo>${slot('x')}</mrow>`, values)).not.toContain('(')
  expect(fill(`<mrow><mi>v</mi><mo form="infix">⋅</mo></mrow><mrow>${slot('x')}</mrow>`, values)).toContain('(')
  expect(fill(`<mrow>${slot('tiny')}</mrow>`, values)).toContain('<mn>1.50</mn><mo>⋅</mo><mn>10⁻⁹</mn>')
  expect(fill(slot('unknown'), values)).toBe('<mtext>□</mtext>')
})
