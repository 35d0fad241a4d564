import type { Point } from 'forage-lab'
import type { Detail } from '../display'
import { drawPath } from './layers'
import { applyStyle, type Context, isMarked, marked, type Pen } from './pen'
import { toScreen } from '../view'

/** So many marks are small. */
export const [MANY, SMALL] = [60, 13]

/** The arrows and marks of what was picked. */
export function drawInspection(pen: Pen, details: readonly Detail[]): void {
  const { context, view, size } = pen
  for (const { look, shape, vertices } of [...details].sort((a, b) => a.look.order - b.look.order)) {
    applyStyle(pen, look)
    context.globalAlpha = look.opacity[0]
    if (shape === 'polyline') drawPath(pen, vertices, look)
    else if (shape === 'segments') {
      for (let at = 0; at + 1 < vertices.length; at += 2) {
        const [from, to] = [vertices[at], vertices[at + 1]]
        if (from && to) arrow(context, toScreen(view, size, from), toScreen(view, size, to))
      }
    } else {
      for (const vertex of vertices) {
        const [x, y] = toScreen(view, size, vertex)
        if (isMarked(look)) {
          marked(pen, vertices.length > MANY ? { ...look, point: Math.min(look.point, SMALL) } : look, x, y)
          continue
        }
        context.beginPath()
        context.arc(x, y, look.point / 2 + 1, 0, 2 * Math.PI)
        if (look.dash) context.stroke()
        else context.fill()
      }
    }
    context.globalAlpha = 1
  }
}

const HEAD = 7

export function arrow(context: Context, [x0, y0]: Point, [x1, y1]: Point): void {
  const length = Math.hypot(x1 - x0, y1 - y0)
  if (length < 0.5) return
  context.beginPath()
  context.moveTo(x0, y0)
  context.lineTo(x1, y1)
  context.stroke()
  const head = Math.min(HEAD, length)
  const angle = Math.atan2(y1 - y0, x1 - x0)
  context.beginPath()
  context.moveTo(x1, y1)
  for (const side of [-0.42, 0.42]) context.lineTo(x1 - head * Math.cos(angle + side), y1 - head * Math.sin(angle + side))
  context.closePath()
  context.fill()
}
