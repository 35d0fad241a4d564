import type { Inspection, Look, Point } from 'forage-lab'
import type { Detail } from './display'
import { type Flat, type Size, toScreen, type View } from './view'

/** In an explanation there is only one of each: it is drawn clearly. */
export const clearly = (look: Look): Look => ({
  ...look,
  width: Math.max(look.width, 1.75),
  opacity: [Math.max(look.opacity[0], 0.85), 1],
})

/** Beside what stands out. */
const FAINT = 0.2
const STRONG = 1.6

/** The marks of an explanation as they look; one layer may stand out from the others. */
export const detailsOf = (marks: Inspection['layers'], lookOf: (role: string) => Look, lit: string | null): Detail[] =>
  marks.map(({ role, shape, vertices }) => {
    const look = clearly(lookOf(role))
    const [from, to] = look.opacity
    if (lit === role) return { role, shape, vertices, look: { ...look, width: STRONG * look.width } }
    return { role, shape, vertices, look: lit === null ? look : { ...look, opacity: [FAINT * from, FAINT * to] } }
  })

/** How near a pointer must come to a mark, in pixels. */
const NEAR = 7

/** The layer whose mark lies under a point of the screen. */
export function markAt(details: readonly Detail[], view: View, size: Size, at: Point): string | null {
  let [found, nearest] = [null as string | null, NEAR]
  for (const { role, shape, vertices } of details) {
    const seen = vertices.map((vertex) => toScreen(view, size, vertex))
    const stride = shape === 'segments' ? 2 : 1
    for (let k = 0; k < seen.length; k += stride) {
      const [from, to] = [seen[k], shape === 'points' ? seen[k] : seen[k + 1]]
      const away = from && to ? distance(at, from, to) : Infinity
      if (away < nearest) [found, nearest] = [role, away]
    }
  }
  return found
}

/** From a point to a line between two others. */
function distance([x, y]: Flat, [x0, y0]: Flat, [x1, y1]: Flat): number {
  const [dx, dy] = [x1 - x0, y1 - y0]
  const along = dx === 0 && dy === 0 ? 0 : ((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy)
  const part = Math.min(1, Math.max(0, along))
  return Math.hypot(x - x0 - part * dx, y - y0 - part * dy)
}
