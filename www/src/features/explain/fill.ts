import { short } from '../../text/brief'
import { split, superscript } from '../../text/number'

const PLACEHOLDER = /<mtext>@([\w.-]+)@<\/mtext>/g
/** Between an operator and what follows it in the next piece of a formula. */
const BREAK = /(<\/mo>)<\/mrow><mrow>$/
const SPACE = /(<mspace[^>]*>(<\/mspace>)?)+$/
/** Where a term begins that an arrow stands for. */
const TERM = /<mrow class="[\w-]+">$/
/** After these a minus sign can't be mistaken for a subtraction. */
const OPENS = /(^|<(?:math|mrow|mfrac|msqrt|mtd|mstyle)[^>]*>|<mo[^>]*>[=,(|[→≤≥∈⁡]<\/mo>)$/

/** Puts numbers where a formula's MathML has `@name@`. What has no value stays an empty slot. */
export function fill(mathml: string, values: Readonly<Record<string, number>>): string {
  return mathml.replace(PLACEHOLDER, (_, name: string, at: number) => {
    const value = values[name]
    if (value === undefined) return '<mtext>□</mtext>'
    const before = mathml.slice(0, at).replace(TERM, '').replace(BREAK, '$1').replace(SPACE, '')
    return numeral(value, !OPENS.test(before))
  })
}

/** A number as MathML, in parentheses where its sign would follow something. */
function numeral(value: number, follows: boolean): string {
  if (!Number.isFinite(value)) return `<mi>${Number.isNaN(value) ? '–' : value > 0 ? '∞' : '−∞'}</mi>`
  const { negative, mantissa, exponent } = split(value)
  // Superscript characters, not <msup>: without a mathematical font that one flies too high.
  const power = exponent === undefined ? '' : `<mo>⋅</mo><mn>10${superscript(exponent)}</mn>`
  const body = `<mn>${short(mantissa, value)}</mn>${power}`
  if (!negative) return power ? `<mrow>${body}</mrow>` : body
  const signed = `<mo form="prefix">−</mo>${body}`
  return follows ? `<mrow><mo stretchy="false">(</mo>${signed}<mo stretchy="false">)</mo></mrow>` : `<mrow>${signed}</mrow>`
}
