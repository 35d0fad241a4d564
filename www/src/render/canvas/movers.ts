import { fontOf } from './letters'
import type { GridScene, Point } from 'forage-lab'
import { type Handle, same, type Selection } from '../../scene/edits'
import { movingOf } from '../../scene/moving'
import { apart, KNOB, type Seen, seenAs } from '../hit-moving'
import { toScreen } from '../view'
import type { Context, Pen } from './pen'

/** Below this, in pixels, an obstacle is where it began. */
const AWAY = 2
/** Discs of fewer pixels have their number beside them; of more obstacles nobody asks for it. */
const [NUMBERED, CROWD] = [10, 40]
const HEAD = 9
/** How clear the start of one is that has left it. */
const LEFT = 0.5

export interface Shown {
  /** Where they are now, where the planner tells. */
  now: readonly Point[] | null
  /** Time goes on: where they began is not what is looked at. */
  quiet: boolean
  selection: Selection | null
  hover: Handle | null
  blamed: Selection | null
}

/** Where moving obstacles begin and how they set out, and what of them is selected. */
export function drawMovers(pen: Pen, scene: GridScene, { now, quiet, selection, hover, blamed }: Shown): void {
  const { context, view, size } = pen
  const all = movingOf(scene)
  context.lineJoin = context.lineCap = 'round'
  context.setLineDash([])
  all.forEach((one, index) => {
    const handle: Selection = { kind: 'moving', index }
    const seen = seenAs(one, now?.[index], view, size)
    const selected = same(selection, handle)
    const hovered = (hover?.kind === 'moving' || hover?.kind === 'aim') && hover.index === index
    const colour = same(blamed, handle) ? '--danger' : '--moving'
    const away = apart(seen.start, seen.now) > AWAY
    if (!quiet) {
      context.globalAlpha = away && !selected && !hovered ? LEFT : 1
      if (one.waypoints) ways(pen, [one.center, ...one.waypoints.map(([, x, y]): Point => [x, y])], colour)
      if (away && (selected || hovered)) link(pen, seen, colour)
      if (!now || away || same(blamed, handle)) outline(pen, seen, colour, now !== null)
      if (seen.tip && (!seen.still || selected)) arrow(pen, seen, colour)
      context.globalAlpha = 1
      if (seen.tip && (selected || hovered) && (!seen.still || selected)) knob(pen, seen.knob, hover?.kind === 'aim' && hovered)
    }
    if (all.length > 1 && all.length <= CROWD) number(pen, seen, String(index + 1), colour)
    if (selected) ring(pen, seen, '--focus')
    else if (hovered && !quiet) ring(pen, seen, '--line-strong')
  })
}

function circle(context: Context, [x, y]: Point, radius: number): void {
  context.beginPath()
  context.arc(x, y, Math.max(0, radius), 0, 2 * Math.PI)
}

/** A halo lifts lines off walls and pheromone. */
function stroke({ context, palette }: Pen, colour: string, width: number, dash: number[] = [], halo = 2.5): void {
  context.setLineDash([])
  context.strokeStyle = palette.get('--stage')
  context.lineWidth = width + halo
  context.stroke()
  context.setLineDash(dash)
  context.strokeStyle = palette.get(colour)
  context.lineWidth = width
  context.stroke()
  context.setLineDash([])
}

function outline(pen: Pen, { start, radius }: Seen, colour: string, left: boolean): void {
  const { context, palette } = pen
  circle(context, start, radius)
  if (!left) {
    context.fillStyle = palette.get('--moving-soft')
    context.fill()
  }
  stroke(pen, colour, 1.75, [4, 3])
}

/** From where it begins to where it is. */
function link(pen: Pen, { start, now }: Seen, colour: string): void {
  const { context } = pen
  context.beginPath()
  context.moveTo(...start)
  context.lineTo(...now)
  stroke(pen, colour, 1, [1, 4])
}

/** How far it goes in a second. */
function arrow(pen: Pen, { start, radius, tip, still }: Seen, colour: string): void {
  const { context, palette } = pen
  if (!tip) return
  const length = apart(start, tip)
  const [x, y] = [(tip[0] - start[0]) / length, (tip[1] - start[1]) / length]
  const [neckX, neckY] = [tip[0] - (still ? 0 : HEAD * x), tip[1] - (still ? 0 : HEAD * y)]
  context.beginPath()
  context.moveTo(start[0] + radius * x, start[1] + radius * y)
  context.lineTo(neckX, neckY)
  stroke(pen, colour, still ? 1.25 : 2, still ? [2, 3] : [])
  circle(context, start, 2.25)
  context.fillStyle = palette.get(colour)
  context.fill()
  if (still) return
  const side = 0.55 * HEAD
  context.beginPath()
  context.moveTo(...tip)
  context.lineTo(neckX - side * y, neckY + side * x)
  context.lineTo(neckX + side * y, neckY - side * x)
  context.closePath()
  stroke(pen, colour, 1)
  context.fill()
}

/** What to pull at. */
function knob({ context, palette }: Pen, tip: Point, held: boolean): void {
  circle(context, tip, KNOB)
  context.fillStyle = palette.get(held ? '--focus' : '--surface')
  context.fill()
  context.lineWidth = 2
  context.strokeStyle = palette.get('--focus')
  context.stroke()
}

/** A dotted line through its way-points, with a ring at the last: there it stays. */
function ways(pen: Pen, points: readonly Point[], colour: string): void {
  const { context, view, size, palette } = pen
  const places = points.map((point) => toScreen(view, size, point))
  context.beginPath()
  // A round that is made again and again is one line.
  const drawn = new Set<string>()
  places.slice(1).forEach((to, at) => {
    const from = places[at] ?? to
    const key = [from.join(), to.join()].sort().join(' ')
    if (drawn.has(key)) return
    drawn.add(key)
    context.moveTo(...from)
    context.lineTo(...to)
  })
  stroke(pen, colour, 1.75, [1, 4])
  context.fillStyle = palette.get(colour)
  places.slice(0, -1).forEach((place) => {
    circle(context, place, 2.5)
    context.fill()
  })
  const last = places.at(-1)
  if (!last) return
  circle(context, last, 4)
  context.fillStyle = palette.get('--stage')
  context.fill()
  stroke(pen, colour, 1.75, [], 0)
}

function number({ context, palette }: Pen, { now: [x, y], radius, heading }: Seen, label: string, colour: string): void {
  const inside = radius >= NUMBERED
  context.font = fontOf('600 11px')
  context.textAlign = 'center'
  context.textBaseline = 'middle'
  // Where the arrow isn't.
  const away = inside ? 0 : radius + 11
  const [left, top] = [x - away * heading[0], y - away * heading[1] + 0.5]
  context.lineWidth = 4
  context.strokeStyle = palette.get(inside ? '--moving-soft' : '--stage')
  context.strokeText(label, left, top)
  context.fillStyle = palette.get(colour)
  context.fillText(label, left, top)
}

/** About where it is now, where it can be seen. */
function ring({ context, palette }: Pen, { now, radius }: Seen, token: string): void {
  circle(context, now, Math.max(radius, 3) + 4)
  context.lineWidth = 2
  context.strokeStyle = palette.get(token)
  context.stroke()
}
