import { punctuation } from '../locales/en/punctuation'

/** How panels write numbers. A reading keeps its number of digits, so that it doesn't jitter while it changes. */

const DIGITS = 4
/** A thin space that doesn't break, as the thousands' separator. */
const GROUP = '\u202f'
const MINUS = '−'
export const NONE = '–'

const SUPERSCRIPT: Readonly<Record<string, string>> = {
  '0': '⁰',
  '1': '¹',
  '2': '²',
  '3': '³',
  '4': '⁴',
  '5': '⁵',
  '6': '⁶',
  '7': '⁷',
  '8': '⁸',
  '9': '⁹',
  '-': '⁻',
}

export interface Split {
  negative: boolean
  mantissa: string
  /** Absent where the mantissa alone says it. */
  exponent?: number
}

/** A finite number's parts, to `digits` significant digits; integers whole. */
export function split(value: number, digits = DIGITS): Split {
  const size = Math.abs(value)
  const negative = value < 0
  if (size === 0) return { negative: false, mantissa: '0' }
  if (Number.isInteger(size) && size < 1e9) return { negative, mantissa: grouped(String(size)) }
  if (size >= 1e-3 && size < 1e6) {
    const text = size.toPrecision(digits)
    return { negative, mantissa: text.includes('e') ? grouped(String(Math.round(size))) : text }
  }
  const [mantissa = '0', exponent = '0'] = size.toExponential(Math.max(digits - 2, 0)).split('e')
  return { negative, mantissa, exponent: Number(exponent) }
}

function grouped(integer: string): string {
  return integer.length < 5 ? integer : integer.replace(/\B(?=(\d{3})+$)/g, GROUP)
}

/** E.g. `12.14`, `−0.0312`, `75 000`, `3.21×10⁻¹²`. */
export function number(value: number | null | undefined, digits = DIGITS): string {
  if (value === null || value === undefined || Number.isNaN(value)) return NONE
  if (!Number.isFinite(value)) return value > 0 ? '∞' : `${MINUS}∞`
  const { negative, mantissa, exponent } = split(value, digits)
  const power = exponent === undefined ? '' : `×10${superscript(exponent)}`
  return `${negative ? MINUS : ''}${mantissa}${power}`
}

/** A parameter's value, with no digit lost. */
export function exactly(value: number | string | boolean): string {
  if (typeof value !== 'number') return String(value)
  const [mantissa = '', exponent] = Math.abs(value).toString().split('e')
  const text = exponent === undefined && Number.isInteger(value) ? grouped(mantissa) : mantissa
  return `${value < 0 ? MINUS : ''}${text}${exponent === undefined ? '' : `×10${superscript(Number(exponent))}`}`
}

/** A share as per cent, signed if asked for: `+0.21 %`. */
export function percent(share: number, signed = false): string {
  const value = share * 100
  const size = Math.abs(value)
  const text = size >= 100 ? size.toFixed(0) : size >= 0.01 || size === 0 ? size.toFixed(2) : size < 1e-9 ? '0.00' : number(size, 2)
  const sign = text === '0.00' ? '' : value < 0 ? MINUS : signed ? '+' : ''
  return punctuation.percent(sign + text)
}

/** A number with its unit, as a drive's or a motion's columns have it. */
export const withUnit = (value: number | null | undefined, unit: string, digits = DIGITS): string =>
  number(value, digits) + (unit === '' || unit === '°' ? unit : ` ${unit}`)

/** Radians as degrees. */
export function angle(radians: number): string {
  return `${number((radians * 180) / Math.PI)}°`
}

export function superscript(exponent: number): string {
  return [...String(exponent)].map((digit) => SUPERSCRIPT[digit] ?? digit).join('')
}
