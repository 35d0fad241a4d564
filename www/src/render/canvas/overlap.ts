import type { Disc } from 'forage-lab'
import { PLAIN, type Style } from '../looks'
import { type Lines, type Pen, pathOf } from './pen'
import { toScreen } from '../view'

/** How near a rim is not yet inside, in pixels: what touches isn't wrong. */
export const TOUCH = 1

export const WRONG: Style = { ...PLAIN, color: '--danger', width: 4, opacity: [1, 1] }

/** Whatever part of the result lies inside a disc is drawn in red. */
export function insideDiscs(pen: Pen, lines: Lines, discs: readonly Disc[]): void {
  if (discs.length === 0) return
  const { context, view, size } = pen
  const inside = pathOf(pen)
  for (const { center, radius } of discs) {
    const [x, y] = toScreen(view, size, center)
    inside.moveTo(x + radius * view.scale, y)
    inside.arc(x, y, Math.max(0, radius * view.scale - TOUCH), 0, 2 * Math.PI)
  }
  context.save()
  context.clip(inside)
  lines.stroke(WRONG)
  context.restore()
}
