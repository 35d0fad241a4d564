import type { Inspection, Point3 } from 'forage-lab'
import type { Report } from '../engine/protocol'
import type { Names } from '../render/looks'

export const NODES = 'nodes'

/** Where the node of a tree is that is looked at closer; null if it is none. */
export function nodeOf({ item, layers }: Inspection, frame: Report, names: Names): Point3 | null {
  if (item.role !== NODES) return null
  // Of a big tree not every node is drawn.
  const drawn =
    frame.thinning === 1
      ? vertexOf(
          frame,
          names.layers.findIndex(({ role }) => role === NODES),
          item.index,
        )
      : null
  return drawn ?? layers.find(({ role, shape }) => role === 'after' && shape === 'points')?.vertices[0] ?? null
}

/** A layer's vertex by its number, over all of its pieces. */
function vertexOf({ buffer, vertices, spans }: Report, of: number, index: number): Point3 | null {
  const numbers = new Float32Array(buffer, 0, vertices)
  const table = new Uint32Array(buffer, vertices * 4, spans)
  let left = index
  for (let at = 0; at < table.length; at += 4) {
    const [layer, , first = 0, count = 0] = table.subarray(at, at + 4)
    if (layer !== of) continue
    if (left < count) {
      const [x = 0, y = 0, z = 0] = numbers.subarray(4 * (first + left), 4 * (first + left) + 3)
      return [x, y, z]
    }
    left -= count
  }
  return null
}
