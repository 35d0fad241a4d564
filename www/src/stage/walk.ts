import type { Point } from 'forage'
import { type Ant, placeAt, type Walk } from '../state/walk'
import type { Pen } from './pen'
import { rise, toScreen } from './view'

/** The last steps, drawn more clearly. */
const TAIL = 5
const BODY = 3.5
const MARK = 5

/** The ants at a moment of their walk, with their ways behind them. */
export function drawWalk(pen: Pen, { ants }: Walk, time: number): void {
  const { context, palette, view, size } = pen
  context.lineJoin = 'round'
  context.lineCap = 'round'
  context.strokeStyle = palette.get('--ant')
  context.lineWidth = 1
  for (const ant of ants) {
    context.globalAlpha = lost(ant, time) ? 0.12 : 0.3
    context.beginPath()
    way(pen, ant, 0, time)
    context.stroke()
  }
  context.globalAlpha = 0.85
  context.lineWidth = 2
  context.beginPath()
  for (const ant of ants) if (time < ant.last) way(pen, ant, Math.max(0, Math.floor(time) - TAIL), time)
  context.stroke()
  context.globalAlpha = 1
  for (const ant of ants) mark(pen, ant, toScreen(view, size, placeAt(ant, time)), time)
}

const lost = (ant: Ant, time: number): boolean => !ant.arrived && time >= ant.last

function way({ context, view, size }: Pen, ant: Ant, from: number, time: number): void {
  const [left, top, up] = [size.width / 2 - view.x * view.scale, size.height / 2 + rise(view) * view.y * view.scale, rise(view) * view.scale]
  const last = Math.min(Math.floor(time), ant.last)
  for (let step = from; step <= last; step += 1) {
    const [x, y] = [left + (ant.places[2 * step] ?? 0) * view.scale, top - (ant.places[2 * step + 1] ?? 0) * up]
    if (step === from) context.moveTo(x, y)
    else context.lineTo(x, y)
  }
  context.lineTo(...toScreen(view, size, placeAt(ant, time)))
}

/** On its way a dot, at the goal a dot in a ring, at a dead end a cross. */
function mark({ context, palette }: Pen, ant: Ant, [x, y]: Point, time: number): void {
  context.beginPath()
  if (lost(ant, time)) {
    for (const side of [-1, 1]) {
      context.moveTo(x - MARK + 1, y - (MARK - 1) * side)
      context.lineTo(x + MARK - 1, y + (MARK - 1) * side)
    }
    outlined(context, palette.get('--danger'), palette.get('--stage'))
    return
  }
  context.arc(x, y, BODY, 0, 2 * Math.PI)
  context.fillStyle = palette.get('--ant')
  context.fill()
  if (time >= ant.last) {
    context.beginPath()
    context.arc(x, y, BODY + 4, 0, 2 * Math.PI)
  }
  context.lineWidth = 1.5
  context.strokeStyle = palette.get(time >= ant.last ? '--ant' : '--stage')
  context.stroke()
}

function outlined(context: CanvasRenderingContext2D, colour: string, ground: string): void {
  context.strokeStyle = ground
  context.lineWidth = 4.5
  context.stroke()
  context.strokeStyle = colour
  context.lineWidth = 2
  context.stroke()
}
