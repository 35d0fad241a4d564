import type { GridScene, Point, Scene } from 'forage-lab'
import { stopsOf } from '../state/stops'
import type { FrameMessage } from '../worker/protocol'
import { applyStyle, Lines, type Pen, points } from './pen'
import { resultOf, STOPS, type Style, styleBeside, styleOf } from './styles'
import type { Piece } from './tubes'
import { type Flat, toScreen } from './view'
import { insideDiscs } from './wrong'

export interface Names {
  roles: string[]
  shapes: string[]
}

/** What of a frame is drawn. */
export type Layers = Pick<FrameMessage, 'buffer' | 'vertices' | 'spans'>

type Draw = (pen: Pen, style: Style, vertices: Float32Array, pieces: readonly Piece[]) => void

/** What not every scene needs, once it is there. */
interface More {
  /** Roles that have a drawing of their own. */
  own?: Readonly<Record<string, Draw>>
  drawTubes?: Draw
  drawArrows?(pen: Pen, style: Style, vertices: Float32Array, first: number, count: number): void
  insideCells?(pen: Pen, scene: GridScene, path: readonly Point[]): void
}

/** Draws a frame's layers that are on, in the style sheet's order. */
export function drawLayers(pen: Pen, frame: Layers, names: Names, on: (role: string) => boolean, scene: Scene, more: More): void {
  const vertices = new Float32Array(frame.buffer, 0, frame.vertices)
  const spans = new Uint32Array(frame.buffer, frame.vertices * 4, frame.spans)
  const order = (role: number): number => styleOf(names.roles[role] ?? '').order
  const roles = [...rolesIn(spans)]
    .filter((role) => names.roles[role] !== STOPS && on(names.roles[role] ?? ''))
    .sort((a, b) => order(a) - order(b))
  const result = resultOf(roles.map((role) => names.roles[role] ?? ''))
  for (const number of roles) {
    const role = names.roles[number] ?? ''
    const style = stopsOf(scene).length > CROWD ? thinner(styleBeside(role, result)) : styleBeside(role, result)
    const pieces = piecesOf(spans, number, names.shapes)
    const own = more.own?.[role] ?? (pieces[0]?.shape === 'tube' ? more.drawTubes : undefined)
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
    if (role === result || style.lifted) halo(lines, style)
    lines.stroke(style)
    if (style.arrows) for (const [first, count] of ways) more.drawArrows?.(pen, style, vertices, first, count)
    if (role !== result) continue
    if (scene.kind === 'discs') insideDiscs(pen, lines, scene.discs)
    if (scene.kind === 'grid') for (const [first, count] of ways) more.insideCells?.(pen, scene, pathOf(vertices, first, count))
  }
}

/** What a role is made of. */
export function piecesOf(spans: Uint32Array, role: number, shapes: readonly string[]): Piece[] {
  const pieces: Piece[] = []
  for (let at = 0; at < spans.length; at += 4) {
    if (spans[at] === role) pieces.push({ shape: shapes[spans[at + 1] ?? 0] ?? '', first: spans[at + 2] ?? 0, count: spans[at + 3] ?? 0 })
  }
  return pieces
}

/** Whether anything of a role that is only drawn from near is in the frame. */
export function isNear(frame: Layers, names: Names, on: (role: string) => boolean): boolean {
  const spans = new Uint32Array(frame.buffer, frame.vertices * 4, frame.spans)
  return [...rolesIn(spans)].some((number) => {
    const role = names.roles[number] ?? ''
    return styleOf(role).near === true && on(role)
  })
}

function pathOf(vertices: Float32Array, first: number, count: number): Point[] {
  return Array.from({ length: count }, (_, at) => [vertices[4 * (first + at)] ?? 0, vertices[4 * (first + at) + 1] ?? 0])
}

function rolesIn(spans: Uint32Array): Set<number> {
  const roles = new Set<number>()
  for (let at = 0; at < spans.length; at += 4) roles.add(spans[at] ?? 0)
  return roles
}

/** Tours of more stops are thinner. */
const CROWD = 100
const thinner = (style: Style): Style => (style.arrows ? { ...style, width: 1.75 } : style)

/** Lifts the result, and what else must be seen, off the crowd beneath it. */
function halo(lines: Lines, style: Style): void {
  lines.stroke({ ...style, dash: [], colour: '--stage', width: style.width + 3, alpha: [0.75, 0.75] })
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
