import { exactly, number, percent, split } from './number'

/** Without zeros at the end, if the number has no further digits. */
export function short(mantissa: string, value: number): string {
  const brief = mantissa.replace(/\.?0+$/, '')
  return mantissa.includes('.') && Number(brief) === Math.abs(value) ? brief : mantissa
}

/** As a text writes a number that doesn't change: `4.5` and `0.03`, not `4.500` and `0.03000`. */
export function brief(value: number): string {
  if (!Number.isFinite(value)) return number(value)
  const { mantissa, exponent } = split(value)
  return exponent === undefined && short(mantissa, value) !== mantissa ? exactly(value) : number(value)
}

/** The same of a share as per cent: `0 %`, `12.5 %`, `33.33 %`. */
export function briefPercent(share: number): string {
  const text = percent(share)
  const [, digits = ''] = /([\d.]+) ?%$/.exec(text) ?? []
  const fewer = digits.replace(/\.?0+$/, '')
  return digits.includes('.') && Math.abs(Number(fewer) - Math.abs(share * 100)) < 1e-9 ? text.replace(digits, fewer) : text
}
