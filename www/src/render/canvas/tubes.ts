import type { Color } from 'forage-lab'
import type { Context, Path, Pen } from './pen'
import { rise } from '../view'

/** A piece of a layer: its shape, and which of the frame's vertices are its own. */
export interface Piece {
  shape: string
  first: number
  count: number
}

/** x and y on the screen, and half the width there. */
export type Bead = [x: number, y: number, half: number]

/** A frame's vertices on the screen; a tube's weight is half its width. */
export function beads({ view, size }: Pen, vertices: Float32Array, { first, count }: Piece): Bead[] {
  const { scale } = view
  const left = size.width / 2 - view.x * scale
  const up = rise(view) * scale
  const top = size.height / 2 + view.y * up
  return Array.from({ length: count }, (_, k) => {
    const at = 4 * (first + k)
    return [left + (vertices[at] ?? 0) * scale, top - (vertices[at + 1] ?? 0) * up, (vertices[at + 3] ?? 0) * scale]
  })
}

/** Adds a tube to a path: discs at its vertices, and between them what a disc sweeps that grows or shrinks on its way. All wind
 * the same way round, so that what overlaps is filled once. */
export function tube(path: Path, line: readonly Bead[], more = 0): void {
  line.forEach(([x, y, half], at) => {
    const r = half + more
    path.moveTo(x + r, y)
    path.arc(x, y, r, 0, 2 * Math.PI)
    const next = line[at + 1]
    if (next) sweep(path, [x, y, r], [next[0], next[1], next[2] + more])
  })
}

/** Between the points where the lines that touch both discs do so. */
function sweep(path: Path, [x0, y0, r0]: Bead, [x1, y1, r1]: Bead): void {
  const length = Math.hypot(x1 - x0, y1 - y0)
  // One disc lies in the other.
  if (length <= Math.abs(r0 - r1) || length === 0) return
  const [dx, dy] = [(x1 - x0) / length, (y1 - y0) / length]
  const along = (r0 - r1) / length
  const across = Math.sqrt(1 - along * along)
  const side = (by: 1 | -1): [number, number] => [along * dx - by * across * dy, along * dy + by * across * dx]
  const [[ax, ay], [bx, by]] = [side(1), side(-1)]
  path.moveTo(x0 + r0 * bx, y0 + r0 * by)
  path.lineTo(x1 + r1 * bx, y1 + r1 * by)
  path.lineTo(x1 + r1 * ax, y1 + r1 * ay)
  path.lineTo(x0 + r0 * ax, y0 + r0 * ay)
  path.closePath()
}

const hatches = new Map<string, CanvasPattern>()
/** A hatch's lines are so far apart, in pixels. */
const PITCH = 7

/** Thin slanting lines of a colour. They lie still on the plane while the view moves. */
export function hatch({ context, view, size, density, palette }: Pen, token: string | Color): CanvasPattern | null {
  const key = [palette.get(token), density].join()
  // A file has patterns of its own.
  const pattern = (context.path ? undefined : hatches.get(key)) ?? tiled(context, palette.get(token), density)
  if (!pattern) return null
  if (!context.path) hatches.set(key, pattern)
  const side = Math.round(PITCH * density) / density
  const origin = (middle: number, at: number): number => (middle + at * view.scale) % side
  pattern.setTransform(
    new DOMMatrix([1 / density, 0, 0, 1 / density, origin(size.width / 2, -view.x), origin(size.height / 2, rise(view) * view.y)]),
  )
  return pattern
}

function tiled(context: Context, colour: string, density: number): CanvasPattern | null {
  const side = Math.round(PITCH * density)
  const tile = new OffscreenCanvas(side, side)
  const ink = tile.getContext('2d')
  if (!ink) return null
  ink.strokeStyle = colour
  ink.lineWidth = 1.1 * density
  for (const by of [-side, 0, side]) {
    ink.moveTo(by - 2, side + 2)
    ink.lineTo(by + side + 2, -2)
  }
  ink.stroke()
  return context.createPattern(tile, 'repeat')
}
