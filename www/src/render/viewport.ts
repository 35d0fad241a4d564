import type { Layer } from 'forage-lab'
import type { Viewport } from './frame'
import { rampOf } from './looks'
import { type Size, toScene, type View } from './view'

/** What the worker has to know of how these layers are seen. */
export function viewportOf(shown: readonly Layer[], view: View, size: Size, dark: boolean): Viewport {
  const near = shown.some((layer) => layer.look.near)
  const [left, top] = toScene(view, size, [0, 0])
  const [right, bottom] = toScene(view, size, [size.width, size.height])
  return {
    fields: shown.flatMap(({ role, look: { ramp } }) => (ramp ? { role, ramp: rampOf(ramp, dark) } : [])),
    window: near ? { min: [left, Math.min(top, bottom)], max: [right, Math.max(top, bottom)] } : null,
  }
}
