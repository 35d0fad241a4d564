import { fontOf, small } from './letters'
import type { DiscsScene, Scene } from 'forage-lab'
import { discOf, ends, type Handle, place, type Plane, same, type Selection } from '../../scene/edits'
import type { Display } from '../display'
import type { Context, Pen } from './pen'
import { type Box, extent, tick, toScene, toScreen } from '../view'

export const HANDLE = 7

/** Lines and numbers of the plane, and the edge of where things happen. */
export function drawGrid(pen: Pen, scene: Scene, lines: boolean): void {
  const { context, view, size, palette } = pen
  // Places that are made up have no coordinates.
  if (scene.kind === 'tour' && !scene.points?.length) return
  const [left, top] = toScene(view, size, [0, 0])
  const [right, bottom] = toScene(view, size, [size.width, size.height])
  const step = tick(view.scale, 64)
  context.setLineDash([])
  context.lineWidth = 1
  context.font = small()
  const digits = Math.max(0, -Math.floor(Math.log10(step)))
  const label = (value: number): string => value.toFixed(Math.min(digits, 8)).replace('-', '−')
  const snap = (value: number): number => Math.round(value) + 0.5
  context.strokeStyle = palette.get('--grid')
  context.beginPath()
  const columns = ticks(left, right, step).map((value) => [value, snap(toScreen(view, size, [value, 0])[0])] as const)
  const rows = ticks(Math.min(bottom, top), Math.max(bottom, top), step).map(
    (value) => [value, snap(toScreen(view, size, [0, value])[1])] as const,
  )
  if (lines) {
    for (const [, x] of columns) context.rect(x, -1, 0, size.height + 2)
    for (const [, y] of rows) context.rect(-1, y, size.width + 2, 0)
    context.stroke()
  }
  frameOf(pen, extent(scene))
  context.fillStyle = palette.get('--ink-2')
  context.textAlign = 'center'
  context.textBaseline = 'bottom'
  for (const [value, x] of columns)
    if (x > 34 && x < size.width - 12) plate(context, palette.get('--stage'), label(value), x, size.height - 4)
  context.textAlign = 'left'
  context.textBaseline = 'middle'
  for (const [value, y] of rows) if (y > 12 && y < size.height - 24) plate(context, palette.get('--stage'), label(value), 7, y)
}

/** What the axes are called, where a file has no page around it. */
export function drawAxisTitles({ context, size, palette }: Pen, scene: Scene): void {
  if (scene.kind === 'arm' || (scene.kind === 'tour' && !scene.points?.length)) return
  const [x, y] = scene.kind === 'function' ? ['x₁', 'x₂'] : ['x', 'y']
  context.font = fontOf('italic 11px')
  context.fillStyle = palette.get('--ink')
  context.textBaseline = 'middle'
  context.textAlign = 'right'
  plate(context, palette.get('--stage'), x, size.width - 7, size.height - 22)
  context.textAlign = 'left'
  plate(context, palette.get('--stage'), y, 22, 10)
}

/** Text on a ground of its own. */
export function plate(context: Context, ground: string, text: string, x: number, y: number): void {
  const ink = context.fillStyle
  context.lineWidth = 3
  context.strokeStyle = ground
  context.lineJoin = 'round'
  context.strokeText(text, x, y)
  context.fillStyle = ink
  context.fillText(text, x, y)
}

function ticks(from: number, to: number, step: number): number[] {
  const first = Math.ceil(from / step)
  const count = Math.min(200, Math.floor(to / step) - first + 1)
  return Array.from({ length: Math.max(0, count) }, (_, at) => (first + at) * step)
}

function frameOf({ context, view, size, palette }: Pen, { min, max }: Box): void {
  const [left, bottom] = toScreen(view, size, min)
  const [right, top] = toScreen(view, size, max)
  context.strokeStyle = palette.get('--axis')
  context.lineWidth = 1
  const [high, low] = [Math.min(top, bottom), Math.max(top, bottom)]
  context.strokeRect(Math.round(left) + 0.5, Math.round(high) + 0.5, Math.round(right - left), Math.round(low - high))
}

export function drawDiscs(pen: Pen, { discs }: DiscsScene, blamed: Selection | null): void {
  const { context, view, size, palette } = pen
  context.setLineDash([])
  discs.forEach(({ center, radius }, index) => {
    const [x, y] = toScreen(view, size, center)
    const wrong = same(blamed, { kind: 'disc', index })
    context.beginPath()
    context.arc(x, y, Math.max(0, radius * view.scale), 0, 2 * Math.PI)
    context.fillStyle = palette.get(wrong ? '--danger-soft' : '--disc')
    context.fill()
    context.lineWidth = 1.25
    context.strokeStyle = palette.get(wrong ? '--danger' : '--disc-edge')
    context.stroke()
  })
}

/** The room that a label needs, in pixels, with the column of tools beside it. */
const LABEL = 104

/** What of a scene is meant. */
type Meant = Pick<Display, 'touring' | 'selection' | 'hover' | 'blamed' | 'words'>

/** Start, goal, and what of them and of the discs is selected or under the pointer. */
export function drawEnds(pen: Pen, scene: Plane, { touring, selection, hover, blamed, words }: Meant): void {
  const { context, view, size, palette } = pen
  context.setLineDash([])
  // A tour has no ends of its own, and its stops may lie there.
  for (const { kind, at } of touring ? [] : ends(scene)) {
    const [x, y] = toScreen(view, size, at)
    const colour = palette.get(blamed?.kind === kind ? '--danger' : '--ink')
    context.beginPath()
    context.arc(x, y, HANDLE, 0, 2 * Math.PI)
    context.fillStyle = kind === 'start' ? colour : palette.get('--stage')
    context.strokeStyle = colour
    context.lineWidth = 2
    context.fill()
    context.stroke()
    if (kind === 'goal') {
      context.beginPath()
      context.arc(x, y, 2.5, 0, 2 * Math.PI)
      context.fillStyle = colour
      context.fill()
    }
    context.font = fontOf('600 12px')
    context.fillStyle = colour
    context.textBaseline = 'middle'
    // Away from the path, where there is room.
    const other = ends(scene).find((end) => end.kind !== kind)?.at
    const [otherX, otherY] = other ? toScreen(view, size, other) : [x, y]
    const leftwards = x > size.width - LABEL || (otherX > x && x > 64)
    const below = !leftwards && otherX > x && otherY < y
    context.textAlign = leftwards ? 'right' : 'left'
    plate(context, palette.get('--stage'), words[kind], x + (leftwards ? -13 : 13), y + (below ? 14 : -12))
  }
  if (isRinged(hover)) ring(pen, scene, hover, palette.get('--line-strong'))
  if (isRinged(selection)) ring(pen, scene, selection, palette.get('--focus'))
  const held = hover?.kind === 'rim' || hover?.kind === 'disc' ? hover.index : selection?.kind === 'disc' ? selection.index : null
  if (held !== null) rim(pen, scene, held)
}

/** Stops and what moves are drawn elsewhere. */
const isRinged = (handle: Handle | null): handle is Selection => handle !== null && ['start', 'goal', 'disc'].includes(handle.kind)

function ring({ context, view, size }: Pen, scene: Plane, handle: Selection, colour: string): void {
  const [x, y] = toScreen(view, size, place(scene, handle))
  const radius = handle.kind === 'disc' ? (discOf(scene, handle.index)?.radius ?? 0) * view.scale + 3 : HANDLE + 4
  context.beginPath()
  context.arc(x, y, Math.max(0, radius), 0, 2 * Math.PI)
  context.lineWidth = 2
  context.strokeStyle = colour
  context.stroke()
}

function rim({ context, view, size, palette }: Pen, scene: Plane, index: number): void {
  const disc = discOf(scene, index)
  if (!disc) return
  const [x, y] = toScreen(view, size, [disc.center[0] + disc.radius, disc.center[1]])
  context.beginPath()
  context.arc(x, y, 5.5, 0, 2 * Math.PI)
  context.fillStyle = palette.get('--surface')
  context.strokeStyle = palette.get('--focus')
  context.lineWidth = 2
  context.fill()
  context.stroke()
}
