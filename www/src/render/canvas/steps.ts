import type { Point } from 'forage-lab'
import { type Ant, placeAt, type Walk } from '../../scene/steps'
import type { Context, Pen } from './pen'
import { toScreen } from '../view'

/** The last steps, drawn more clearly. */
const TAIL = 5
const MARK = 5
/** Radii of an ant, and from how many on they are small. */
const [BODY, SMALL, MANY] = [3.5, 2.75, 20]
/** So many ways over each other are as dark as they get. */
const DARKEST = 6
/** How far ants of one way walk beside each other: in cells, and at most in pixels. */
const LANES = 0.28
const WIDEST = 7
/** Turns that never come back to the same place. */
const GOLDEN = Math.PI * (3 - Math.sqrt(5))

/** The ants at a moment of their walk, with their ways behind them. */
export function drawWalk(pen: Pen, walk: Walk, time: number): void {
  const { context, palette } = pen
  const lanes = lanesOf(walk, pen.view.scale)
  const each = (act: (ant: Ant, lane: Point) => void): void => {
    for (const [at, ant] of walk.ants.entries()) act(ant, lanes[at] ?? [0, 0])
  }
  const faint = Math.min(0.35, DARKEST / walk.ants.length)
  const body = walk.ants.length > MANY ? SMALL : BODY
  context.lineJoin = context.lineCap = 'round'
  context.strokeStyle = palette.get('--ant')
  context.lineWidth = 1
  each((ant, lane) => {
    context.globalAlpha = lost(ant, time) ? faint / 2 : faint
    context.beginPath()
    way(pen, ant, lane, 0, time)
    context.stroke()
  })
  context.globalAlpha = 0.6
  context.lineWidth = body / 2
  context.beginPath()
  each((ant, lane) => time < ant.last && way(pen, ant, lane, Math.max(0, Math.floor(time) - TAIL), time))
  context.stroke()
  context.globalAlpha = 1
  each((ant, lane) => mark(pen, ant, onScreen(pen, placeAt(ant, time), lane), time, body))
}

/** Ants of one way walk beside each other, so that one sees how many they are. */
function lanesOf({ ants, stride }: Walk, scale: number): Point[] {
  const width = Math.min(LANES * stride * scale, WIDEST)
  return ants.map((_, at) => {
    const away = width * Math.sqrt((at + 0.5) / ants.length)
    return [away * Math.cos(at * GOLDEN), away * Math.sin(at * GOLDEN)]
  })
}

const lost = (ant: Ant, time: number): boolean => !ant.arrived && time >= ant.last

function onScreen({ view, size }: Pen, place: Point, [right, down]: Point): Point {
  const [x, y] = toScreen(view, size, place)
  return [x + right, y + down]
}

function way(pen: Pen, ant: Ant, lane: Point, from: number, time: number): void {
  const { context } = pen
  const last = Math.min(Math.floor(time), ant.last)
  for (let step = from; step <= last; step += 1) {
    const [x, y] = onScreen(pen, [ant.places[2 * step] ?? 0, ant.places[2 * step + 1] ?? 0], lane)
    if (step === from) context.moveTo(x, y)
    else context.lineTo(x, y)
  }
  context.lineTo(...onScreen(pen, placeAt(ant, time), lane))
}

/** On its way a dot, at the goal a ring, at a dead end a cross. */
function mark({ context, palette }: Pen, ant: Ant, [x, y]: Point, time: number, body: number): void {
  context.beginPath()
  if (lost(ant, time)) {
    for (const side of [-1, 1]) {
      context.moveTo(x - MARK + 1, y - (MARK - 1) * side)
      context.lineTo(x + MARK - 1, y + (MARK - 1) * side)
    }
    outlined(context, palette.get('--danger'), palette.get('--stage'))
    return
  }
  const there = time >= ant.last
  context.arc(x, y, there ? body + 1 : body, 0, 2 * Math.PI)
  context.fillStyle = palette.get(there ? '--stage' : '--ant')
  context.fill()
  context.lineWidth = body > SMALL ? 1.5 : 1
  context.strokeStyle = palette.get(there ? '--ant' : '--stage')
  context.stroke()
}

function outlined(context: Context, colour: string, ground: string): void {
  context.strokeStyle = ground
  context.lineWidth = 4.5
  context.stroke()
  context.strokeStyle = colour
  context.lineWidth = 2
  context.stroke()
}
