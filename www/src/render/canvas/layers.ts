import type { GridScene, Layer, Point, Scene } from 'forage-lab'
import { lookBeside, type Names, resultOf, type Style } from '../looks'
import { stopsOf } from '../../scene/stops'
import { type Layers, spansOf, verticesOf } from '../frame'
import { applyStyle, Lines, type Pen, points } from './pen'
import type { Piece } from './tubes'
import { type Flat, toScreen } from '../view'
import { insideDiscs } from './overlap'

type Draw = (pen: Pen, style: Style, vertices: Float32Array, pieces: readonly Piece[]) => void

/** What not every scene needs, once it is there. */
interface More {
  /** The drawing of what is neither points nor lines. */
  own?(style: Style): Draw | undefined
  drawTubes?: Draw
  drawArrows?(pen: Pen, style: Style, vertices: Float32Array, first: number, count: number): void
  insideCells?(pen: Pen, scene: GridScene, path: readonly Point[]): void
}

/** Draws a frame's layers that are on, in the order of their looks. */
export function drawLayers(pen: Pen, frame: Layers, names: Names, on: (role: string) => boolean, scene: Scene, more: More): void {
  const [vertices, spans] = [verticesOf(frame), spansOf(frame)]
  // Stops are drawn with the scene.
  const shown = layersIn(spans, names)
    .filter(([, { role, look }]) => look.glyph !== 'number' && on(role))
    .sort(([, a], [, b]) => a.look.order - b.look.order)
  const result = resultOf(shown.map(([, layer]) => layer))
  for (const [number, { look, role, pickable }] of shown) {
    pen.context.layer?.(role)
    const isResult = result > 0 && look.result === result
    const pieces = piecesOf(spans, number, names.shapes)
    const plain = stopsOf(scene).length > CROWD ? thinner(lookBeside(look, result)) : lookBeside(look, result)
    const style = pickable && !isResult && pieces.length <= FEW ? clear(plain, pieces) : plain
    const own = more.own?.(look) ?? (pieces[0]?.shape === 'tube' ? more.drawTubes : undefined)
    if (own) {
      own(pen, style, vertices, pieces)
      continue
    }
    const lines = new Lines(pen, style.swell !== undefined)
    const ways: [first: number, count: number][] = []
    for (const { shape, first, count } of pieces) {
      if (shape === 'points') points(pen, style, vertices, first, count)
      else if (shape === 'polyline') {
        lines.polyline(vertices, first, count)
        ways.push([first, count])
      } else if (shape === 'segments') lines.segments(vertices, first, count)
    }
    if (isResult || style.lifted) halo(lines, style)
    lines.stroke(style)
    if (style.glyph === 'arrow') for (const [first, count] of ways) more.drawArrows?.(pen, style, vertices, first, count)
    if (!isResult) continue
    if (scene.kind === 'discs') insideDiscs(pen, lines, scene.discs)
    if (scene.kind === 'grid') for (const [first, count] of ways) more.insideCells?.(pen, scene, pathOf(vertices, first, count))
  }
  pen.context.layer?.(null)
}

/** What a layer is made of. */
export function piecesOf(spans: Uint32Array, layer: number, shapes: readonly string[]): Piece[] {
  const pieces: Piece[] = []
  for (let at = 0; at < spans.length; at += 4) {
    if (spans[at] === layer) pieces.push({ shape: shapes[spans[at + 1] ?? 0] ?? '', first: spans[at + 2] ?? 0, count: spans[at + 3] ?? 0 })
  }
  return pieces
}

/** Whether anything that is only drawn from near is in the frame. */
export function isNear(frame: Layers, names: Names, on: (role: string) => boolean): boolean {
  return layersIn(spansOf(frame), names).some(([, { role, look }]) => look.near === true && on(role))
}

function pathOf(vertices: Float32Array, first: number, count: number): Point[] {
  return Array.from({ length: count }, (_, at) => [vertices[4 * (first + at)] ?? 0, vertices[4 * (first + at) + 1] ?? 0])
}

function layersIn(spans: Uint32Array, names: Names): [number: number, layer: Layer][] {
  const numbers = new Set<number>()
  for (let at = 0; at < spans.length; at += 4) numbers.add(spans[at] ?? 0)
  return [...numbers].flatMap((number) => {
    const layer = names.layers[number]
    return layer ? [[number, layer]] : []
  })
}

/** So few members can be followed one by one: they are drawn clearly. */
const FEW = 30
/** Single points are larger, too. */
const LARGE = 8
const clear = (style: Style, pieces: readonly Piece[]): Style => ({
  ...style,
  point: pieces.reduce((sum, { count }) => sum + count, 0) <= FEW ? Math.max(style.point, LARGE) : style.point,
  width: Math.max(style.width, 1.5),
  opacity: [Math.max(style.opacity[0], 0.75), Math.max(style.opacity[1], 0.5)],
})

/** Tours of more stops are thinner. */
const CROWD = 100
const thinner = (style: Style): Style => (style.glyph === 'arrow' ? { ...style, width: 1.75 } : style)

/** Lifts the result, and what else must be seen, off the crowd beneath it. */
function halo(lines: Lines, style: Style): void {
  lines.stroke({ ...style, dash: [], color: '--stage', width: style.width + 3, opacity: [0.75, 0.75] })
}

export function drawPath(pen: Pen, path: readonly Flat[], style: Style): void {
  applyStyle(pen, style)
  trace(pen, path)
  pen.context.stroke()
}

function trace({ context, view, size }: Pen, path: readonly Flat[]): void {
  context.beginPath()
  path.forEach((point, at) => {
    const [x, y] = toScreen(view, size, point)
    if (at === 0) context.moveTo(x, y)
    else context.lineTo(x, y)
  })
}
