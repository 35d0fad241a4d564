import type { Point } from 'forage-lab'
import { discOf, ends, type Handle, type Plane, type Selection } from '../scene/edits'
import { stopsOf } from '../scene/stops'
import { type Size, toScreen, type View } from './view'

/** Of more stops the view could hardly be moved without moving one of them. */
export const CROWD = 60

/** What of the scene lies under a point of the screen. Ends win over stops, rims over discs, small discs over big. */
export function hit(
  scene: Plane,
  view: View,
  size: Size,
  at: Point,
  selection: Selection | null,
  coarse: boolean,
  touring: boolean,
): Handle | null {
  const reach = coarse ? 24 : 11
  const away = (point: Point): number => {
    const [x, y] = toScreen(view, size, point)
    return Math.hypot(x - at[0], y - at[1])
  }
  // A tour has no ends of its own: often they lie where it calls.
  if (!touring) for (const { kind, at: end } of ends(scene).reverse()) if (away(end) <= reach) return { kind }
  const stops = stopsOf(scene).map((stop, index) => ({ index, from: away(stop) }))
  const [stop] = stops.filter(({ from }) => from <= (stops.length > CROWD ? reach / 2 : reach)).sort((a, b) => a.from - b.from)
  if (stop) return { kind: 'stop', index: stop.index }
  if (scene.kind !== 'discs') return null
  if (selection?.kind === 'disc') {
    const disc = discOf(scene, selection.index)
    if (disc && away([disc.center[0] + disc.radius, disc.center[1]]) <= reach) return { kind: 'rim', index: selection.index }
  }
  const near = scene.discs
    .map(({ center, radius }, index) => ({ index, radius: radius * view.scale, from: away(center) }))
    .filter(({ radius, from }) => from <= Math.max(radius + 4, reach))
    .sort((a, b) => a.radius - b.radius)[0]
  if (!near) return null
  const onRim = Math.abs(near.from - near.radius) <= (coarse ? 10 : 5) && near.radius > 14
  return { kind: onRim ? 'rim' : 'disc', index: near.index }
}
