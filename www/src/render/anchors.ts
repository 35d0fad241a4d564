import type { Look, Point } from 'forage-lab'
import { type Layers, spansOf, verticesOf } from './frame'
import type { Names } from './looks'

const VERTEX = 4

const FORMS = ['disc', 'event', 'number'] as const satisfies readonly Look['glyph'][]

/** What of a frame can be pointed at, or is said in words: the vertices of its layers of these forms. */
export type Anchors = Readonly<Record<(typeof FORMS)[number], Float32Array>>

/** Copies them: the frame goes its way. */
export function anchorsOf(frame: Layers, names: Names): Anchors {
  const [disc, event, number] = FORMS.map((form) => {
    const layer = names.layers.findIndex(({ look }) => look.glyph === form)
    return layer < 0 ? new Float32Array() : ofLayer(frame, layer)
  }) as [Float32Array, Float32Array, Float32Array]
  return { disc, event, number }
}

/** A layer's vertices, over all of its pieces. */
function ofLayer(frame: Layers, layer: number): Float32Array {
  const [vertices, spans] = [verticesOf(frame), spansOf(frame)]
  const pieces: Float32Array[] = []
  for (let at = 0; at < spans.length; at += 4) {
    const [of, , first = 0, count = 0] = spans.subarray(at, at + 4)
    if (of === layer) pieces.push(vertices.subarray(VERTEX * first, VERTEX * (first + count)))
  }
  const all = new Float32Array(pieces.reduce((sum, { length }) => sum + length, 0))
  let filled = 0
  for (const piece of pieces) {
    all.set(piece, filled)
    filled += piece.length
  }
  return all
}

const numberOf = (vertices: Float32Array): number => vertices.length / VERTEX

export const pointsOf = (vertices: Float32Array): Point[] =>
  Array.from({ length: numberOf(vertices) }, (_, at): Point => [vertices[VERTEX * at] ?? NaN, vertices[VERTEX * at + 1] ?? NaN])

/** Where so many moving obstacles are now; null where a planner does not say so, or not of so many. */
export const movedTo = ({ disc }: Anchors, count: number): Point[] | null => (count > 0 && numberOf(disc) === count ? pointsOf(disc) : null)

/** The place of each of so many stops in the best tour, from 0; null while there is none. */
export function orderOf({ number }: Anchors, count: number): number[] | null {
  const places = Array.from({ length: numberOf(number) }, (_, stop) => number[VERTEX * stop + 3] ?? -1)
  return places.length === count && places.includes(0) ? places : null
}
