import type { ParameterValue, Scene } from 'forage-lab'

/** Two scenes with the same content. */
export const sameScene = (a: Scene, b: Scene | null): boolean => a === b || (a.name === b?.name && JSON.stringify(a) === JSON.stringify(b))

type Values = Readonly<Record<string, ParameterValue>>

/** Two sets of parameters with the same values. */
export function sameParams(a: Values, b: Values): boolean {
  const names = Object.keys(a)
  return names.length === Object.keys(b).length && names.every((name) => a[name] === b[name])
}
