import type { Look } from '../worker/protocol'
import { styleOf } from './styles'
import { type Size, toScene, type View } from './view'

/** What the worker has to know of how these layers are seen. */
export function lookOf(shown: readonly string[], view: View, size: Size, dark: boolean): Look {
  const near = shown.some((role) => styleOf(role).near)
  const [left, top] = toScene(view, size, [0, 0])
  const [right, bottom] = toScene(view, size, [size.width, size.height])
  return {
    dark,
    fields: shown.filter((role) => styleOf(role).ramp),
    window: near ? { min: [left, Math.min(top, bottom)], max: [right, Math.max(top, bottom)] } : null,
  }
}
