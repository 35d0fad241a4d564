import { type Path, type Pen, pathOf } from './pen'
import type { Style } from '../looks'
import { rise } from '../view'

/** A straight stretch of at least this length, in pixels, has a head in its middle, a long one several. */
const LONG = 34
const APART = 130
/** More heads than about these would hide the line. */
const MOST = 110
/** An arrow head, along and to each side. */
const [HEAD, SIDE] = [5, 4.2]

/** Heads along a line that say in which direction it goes. */
export function drawArrows(
  { context, view, size, palette }: Pen,
  style: Style,
  vertices: Float32Array,
  first: number,
  count: number,
): void {
  const { scale } = view
  const left = size.width / 2 - view.x * scale
  const up = rise(view) * scale
  const top = size.height / 2 + view.y * up
  const x = (at: number): number => left + (vertices[4 * (first + at)] ?? 0) * scale
  const y = (at: number): number => top - (vertices[4 * (first + at) + 1] ?? 0) * up
  let length = 0
  for (let at = 1; at < count; at += 1) length += Math.hypot(x(at) - x(at - 1), y(at) - y(at - 1))
  const apart = Math.max(APART, length / MOST)
  const long = Math.max(LONG, apart / 5)
  const heads = pathOf({ context })
  // Where all stretches are short, there is still one every so often.
  let since = apart / 2
  let from = 0
  for (let to = 1; to < count; to += 1) {
    // Steps in one direction are one stretch.
    if (to + 1 < count && straight(x(from), y(from), x(to), y(to), x(to + 1), y(to + 1))) continue
    const [dx, dy] = [x(to) - x(from), y(to) - y(from)]
    const stretch = Math.hypot(dx, dy)
    const often = stretch > 2 * HEAD && since + stretch / 2 >= 0.7 * apart ? 1 : 0
    const due = stretch >= long ? Math.max(1, Math.round(stretch / apart)) : often
    for (let k = 0; k < due; k += 1) {
      const part = (k + 0.5) / due
      const [hx, hy] = [x(from) + part * dx, y(from) + part * dy]
      if (hx > -HEAD && hy > -HEAD && hx < size.width + HEAD && hy < size.height + HEAD) head(heads, hx, hy, dx / stretch, dy / stretch)
    }
    since = due > 0 ? stretch / (2 * due) : since + stretch
    from = to
  }
  context.setLineDash([])
  context.lineJoin = 'round'
  context.lineWidth = 1.75
  context.strokeStyle = palette.get('--stage')
  context.stroke(heads)
  context.fillStyle = palette.get(style.color)
  context.fill(heads)
}

function straight(x0: number, y0: number, x1: number, y1: number, x2: number, y2: number): boolean {
  const [ax, ay, bx, by] = [x1 - x0, y1 - y0, x2 - x1, y2 - y1]
  return Math.abs(ax * by - ay * bx) < 1e-3 * Math.hypot(ax, ay) * Math.hypot(bx, by) && ax * bx + ay * by > 0
}

function head(path: Path, x: number, y: number, dx: number, dy: number): void {
  const [backX, backY] = [x - HEAD * dx, y - HEAD * dy]
  path.moveTo(x + HEAD * dx, y + HEAD * dy)
  path.lineTo(backX - SIDE * dy, backY + SIDE * dx)
  path.lineTo(backX + SIDE * dy, backY - SIDE * dx)
  path.closePath()
}
