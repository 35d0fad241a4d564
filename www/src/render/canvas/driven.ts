import type { Color } from 'forage-lab'
import type { Names, Style } from '../looks'
import { colorOf } from '../palette'
import { type Layers, spansOf, verticesOf } from '../frame'
import { piecesOf } from './layers'
import { type Path, type Pen, pathOf } from './pen'
import { type Bead, beads, hatch, type Piece, tube } from './tubes'

/** The robot's mark is never smaller than this, in pixels from its centre to its rim. */
const ROBOT = 8
/** Nor is an obstacle's. */
const OBSTACLE = 3

export type Draw = (pen: Pen, style: Style, vertices: Float32Array, pieces: readonly Piece[]) => void

const tubesOf = (pieces: readonly Piece[]): Piece[] => pieces.filter(({ shape }) => shape === 'tube')

function fill({ context }: Pen, path: Path, colour: string | CanvasPattern | null, alpha = 1): void {
  if (!colour) return
  context.globalAlpha = alpha
  context.fillStyle = colour
  context.fill(path)
  context.globalAlpha = 1
}

function stroke({ context, palette }: Pen, path: Path, token: string | Color, width: number, dash: readonly number[] = []): void {
  context.setLineDash([...dash])
  context.lineWidth = width
  context.strokeStyle = palette.get(token)
  context.stroke(path)
  context.setLineDash([])
}

/** Discs with a hatch: walls are plain, and cells are square. */
const moving: Draw = (pen, style, vertices, pieces) => {
  const path = pathOf(pen)
  for (const piece of tubesOf(pieces)) {
    const line = beads(pen, vertices, piece)
    tube(path, line, Math.max(0, OBSTACLE - (line[0]?.[2] ?? 0)))
  }
  stroke(pen, path, '--stage', style.width + 3)
  fill(pen, path, pen.palette.get(style.fill ?? style.color))
  fill(pen, path, hatch(pen, style.color))
  stroke(pen, path, style.color, style.width)
}

/** Shaded, so that what lies beneath can be seen, and outlined as one where ranges overlap. */
const predicted: Draw = (pen, style, vertices, pieces) => {
  const lines = tubesOf(pieces).map((piece) => beads(pen, vertices, piece))
  const path = pathOf(pen)
  for (const line of lines) tube(path, line)
  fill(pen, path, pen.palette.get(style.fill ?? style.color))
  fill(pen, path, hatch(pen, style.color), 0.5)
  rims(pen, lines, style)
}

let sheet: OffscreenCanvas | null = null

/** The rim of what is covered by any of them: what is outside of all, cut out of what is a little wider. */
function rims({ context, size, density, palette }: Pen, lines: readonly Bead[][], { color, width: rim }: Style): void {
  const [width, height] = [Math.max(1, Math.round(size.width * density)), Math.max(1, Math.round(size.height * density))]
  sheet ??= new OffscreenCanvas(width, height)
  if (sheet.width !== width || sheet.height !== height) Object.assign(sheet, { width, height })
  const ink = sheet.getContext('2d')
  if (!ink) return
  ink.setTransform(1, 0, 0, 1, 0, 0)
  ink.clearRect(0, 0, width, height)
  ink.setTransform(density, 0, 0, density, 0, 0)
  const [inner, outer] = [new Path2D(), new Path2D()]
  for (const line of lines) {
    tube(inner, line)
    tube(outer, line, rim)
  }
  ink.fillStyle = palette.get(color)
  ink.fill(outer)
  ink.globalCompositeOperation = 'destination-out'
  ink.fillStyle = colorOf('--light').light
  ink.fill(inner)
  ink.globalCompositeOperation = 'source-over'
  context.drawImage(sheet, 0, 0, size.width, size.height)
}

/** A calm ring. */
const sensor: Draw = (pen, style, vertices, pieces) => {
  const path = pathOf(pen)
  for (const piece of tubesOf(pieces)) tube(path, beads(pen, vertices, piece))
  pen.context.globalAlpha = style.opacity[0]
  stroke(pen, path, style.color, style.width, style.dash)
  pen.context.globalAlpha = 1
}

/** A disc on two wheels with an arrow head where it looks to. */
const robot: Draw = (pen, style, vertices, pieces) => {
  const { context, palette } = pen
  const [disc] = tubesOf(pieces)
  const [body] = disc ? beads(pen, vertices, disc) : []
  if (!body) return
  const [x, y, half] = body
  const radius = Math.max(half, ROBOT)
  const span = pieces.find(({ shape }) => shape === 'segments')
  const [from, to] = span ? beads(pen, vertices, span) : []
  const looks = from && to && Math.hypot(to[0] - from[0], to[1] - from[1]) > 0
  context.save()
  context.translate(x, y)
  if (looks) context.rotate(Math.atan2(to[1] - from[1], to[0] - from[0]))
  const round = pathOf(pen)
  round.arc(0, 0, radius, 0, 2 * Math.PI)
  const wheels = pathOf(pen)
  const [long, wide] = [0.95 * radius, 0.34 * radius]
  for (const side of [-1, 1]) wheels.roundRect(-long / 2, side * radius - wide / 2, long, wide, wide / 2)
  for (const part of [wheels, round]) stroke(pen, part, '--stage', 4)
  fill(pen, wheels, palette.get(style.color))
  fill(pen, round, palette.get(style.fill ?? '--stage'))
  stroke(pen, round, style.color, style.width)
  const head = pathOf(pen)
  if (looks) {
    head.moveTo(0.74 * radius, 0)
    head.lineTo(-0.42 * radius, 0.52 * radius)
    head.lineTo(-0.16 * radius, 0)
    head.lineTo(-0.42 * radius, -0.52 * radius)
    head.closePath()
  } else {
    head.arc(0, 0, 0.35 * radius, 0, 2 * Math.PI)
  }
  fill(pen, head, palette.get(style.color))
  context.restore()
}

/** Where a detour comes back. */
const goal: Draw = (pen, style, vertices, pieces) => {
  const path = pathOf(pen)
  for (const piece of pieces) {
    for (const [x, y] of beads(pen, vertices, piece)) {
      const half = style.point / 2
      path.moveTo(x, y - half)
      path.lineTo(x + half, y)
      path.lineTo(x, y + half)
      path.lineTo(x - half, y)
      path.closePath()
    }
  }
  pen.context.lineJoin = 'round'
  stroke(pen, path, '--stage', style.width + 3)
  fill(pen, path, pen.palette.get('--stage'))
  stroke(pen, path, style.color, style.width)
}

/** The robots of a frame's layers that are on. */
export function drawRobots(pen: Pen, frame: Layers, names: Names, on: (role: string) => boolean): void {
  const [vertices, spans] = [verticesOf(frame), spansOf(frame)]
  names.layers.forEach(({ role, look }, number) => {
    if (look.glyph === 'robot' && on(role)) robot(pen, look, vertices, piecesOf(spans, number, names.shapes))
  })
}

function nothing(): void {}

const GLYPHS: Partial<Record<NonNullable<Style['glyph']>, Draw>> = {
  disc: moving,
  band: predicted,
  reach: sensor,
  // Drawn with start and goal, for which of them lies on top.
  robot: nothing,
  event: nothing,
}

/** The drawing of what is neither points nor lines, or points that are lifted. */
export const own = ({ glyph, lifted }: Style): Draw | undefined => (lifted && glyph === 'diamond' ? goal : glyph && GLYPHS[glyph])

/** Any other tubes: what they cover, shaded. */
export const drawTubes: Draw = (pen, style, vertices, pieces) => {
  const path = pathOf(pen)
  for (const piece of tubesOf(pieces)) tube(path, beads(pen, vertices, piece))
  fill(pen, path, pen.palette.get(style.color), 0.2)
}
