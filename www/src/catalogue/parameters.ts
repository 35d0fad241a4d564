import type { Kind, Layer, Parameter, ParameterValue, Planner, Scene, When } from 'forage-lab'

type Values = Readonly<Record<string, ParameterValue>>

/** A parameter's default on a kind of scene. */
export const standardOn = ({ default: general, defaults }: Parameter, kind: Kind): ParameterValue => defaults[kind] ?? general

const onKind = ({ kinds }: Parameter, kind: Kind): boolean => kinds.length === 0 || kinds.includes(kind)

/** Whether a condition is met. The parameter it asks for must itself mean something: conditions chain. */
export function met(when: When | undefined, parameters: readonly Parameter[], kind: Kind, values: Values): boolean {
  if (!when) return true
  const other = parameters.find(({ name }) => name === when.parameter)
  if (!other || !applies(other, parameters, kind, values)) return false
  return String(values[other.name] ?? standardOn(other, kind)) === when.value
}

/** Whether a parameter means something on this kind of scene beside these values. */
export const applies = (parameter: Parameter, parameters: readonly Parameter[], kind: Kind, values: Values): boolean =>
  onKind(parameter, kind) && met(parameter.when, parameters, kind, values)

/** Those of these values that mean something to a planner on a scene. The rest waits for a planner, a scene and values with which it does. */
export const meaningful = ({ parameters }: Planner, { kind }: Scene, values: Values): Record<string, ParameterValue> =>
  Object.fromEntries(
    Object.entries(values).filter(([key]) =>
      parameters.some((parameter) => parameter.name === key && applies(parameter, parameters, kind, values)),
    ),
  )

/** The layers that a planner can draw with these values. */
export const layersOf = ({ layers, parameters }: Planner, kind: Kind, values: Values): Layer[] =>
  layers.filter(({ when, kinds }) => (kinds?.includes(kind) ?? true) && met(when, parameters, kind, values))
