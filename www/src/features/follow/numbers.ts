import type { ParameterValue } from 'forage-lab'

/** Those of the parameters that are numbers. */
export const numbersOf = (parameters: Readonly<Record<string, ParameterValue>> = {}): Record<string, number> =>
  Object.fromEntries(Object.entries(parameters).filter((pair): pair is [string, number] => typeof pair[1] === 'number'))
