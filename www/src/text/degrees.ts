import { NONE } from './number'

/** An angle to a tenth of a degree, with a minus that is one. */
export function degrees(value: number | undefined): string {
  if (value === undefined || !Number.isFinite(value)) return NONE
  const text = Math.abs(value).toFixed(1)
  return value < 0 && text !== '0.0' ? `−${text}` : text
}
