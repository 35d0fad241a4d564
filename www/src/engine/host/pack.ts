/** Numbers a vertex, and a row of the span table. */
const VERTEX = 4
const SPAN = 4

export interface Packed {
  buffer: ArrayBuffer
  /** Floats of the vertices; behind them the span table. */
  vertices: number
  spans: number
}

/** Copies a frame's layers into one buffer, all but the fields: those travel as pictures. */
export function pack(vertices: Float32Array, spans: Uint32Array, field: number, take: (bytes: number) => ArrayBuffer): Packed {
  let [floats, rows] = [vertices.length, spans.length]
  for (let at = 0; at < spans.length; at += SPAN) {
    if (spans[at + 1] !== field) continue
    floats -= VERTEX * (spans[at + 3] ?? 0)
    rows -= SPAN
  }
  const buffer = take(floats * vertices.BYTES_PER_ELEMENT + rows * spans.BYTES_PER_ELEMENT)
  const points = new Float32Array(buffer, 0, floats)
  const table = new Uint32Array(buffer, points.byteLength, rows)
  if (rows === spans.length) {
    points.set(vertices)
    table.set(spans)
  } else {
    leaveOut(vertices, spans, field, points, table)
  }
  return { buffer, vertices: floats, spans: rows }
}

function leaveOut(vertices: Float32Array, spans: Uint32Array, field: number, points: Float32Array, table: Uint32Array): void {
  let [filled, row] = [0, 0]
  for (let at = 0; at < spans.length; at += SPAN) {
    const [layer = 0, shape = 0, first = 0, count = 0] = spans.subarray(at, at + SPAN)
    if (shape === field) continue
    points.set(vertices.subarray(VERTEX * first, VERTEX * (first + count)), filled)
    table.set([layer, shape, filled / VERTEX, count], row)
    filled += VERTEX * count
    row += SPAN
  }
}
