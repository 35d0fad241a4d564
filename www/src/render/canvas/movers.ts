import type { GridScene, Moving, Point } from 'forage-lab'
import { tipOf } from '../../scene/aiming'
import { type Handle, same, type Selection } from '../../scene/edits'
import type { Names } from '../looks'
import { movingOf } from '../../scene/moving'
import type { Layers } from './layers'
import type { Pen } from './pen'
import { type Size, toScreen, type View } from '../view'

/** An arrow reaches at least this far out of its disc, in pixels. */
const BEYOND = 15
/** Below this, in pixels, an obstacle is where it began. */
const AWAY = 2
/** How near a hand must come, in pixels. */
const [NEAR, COARSE] = [11, 24]
/** Discs of fewer pixels have their number beside them; of more obstacles nobody asks for it. */
const [NUMBERED, CROWD] = [10, 40]
const KNOB = 5.5
const HEAD = 9
/** How clear the start of one is that has left it. */
const LEFT = 0.5

/** The vertices of the layer with this form. */
export function placesOf(frame: Layers, names: Names, glyph: 'disc' | 'event'): Point[] {
  const vertices = new Float32Array(frame.buffer, 0, frame.vertices)
  const spans = new Uint32Array(frame.buffer, frame.vertices * 4, frame.spans)
  const number = names.layers.findIndex(({ look }) => look.glyph === glyph)
  const found: Point[] = []
  for (let at = 0; at < spans.length; at += 4) {
    const [of, , first = 0, count = 0] = spans.subarray(at, at + 4)
    if (of !== number) continue
    for (let vertex = 4 * first; vertex < 4 * (first + count); vertex += 4)
      found.push([vertices[vertex] ?? NaN, vertices[vertex + 1] ?? NaN])
  }
  return found
}

/** A frame's obstacles where they are now; nothing where a planner doesn't tell of them, or not of so many. */
export function placesNow(frame: Layers, names: Names, count: number): Point[] | null {
  const found = count > 0 ? placesOf(frame, names, 'disc') : []
  return count > 0 && found.length === count ? found : null
}

/** The event at a point of the screen: of several the nearest, and at one place the latest. */
export function eventAt(frame: Layers, names: Names, view: View, size: Size, at: Point, coarse: boolean): number | null {
  let best = { index: -1, from: coarse ? COARSE : NEAR }
  placesOf(frame, names, 'event').forEach((place, index) => {
    const from = apart(toScreen(view, size, place), at)
    if (from <= best.from) best = { index, from }
  })
  return best.index < 0 ? null : best.index
}

interface Seen {
  /** Where its disc begins, and where it is now. */
  start: Point
  now: Point
  radius: number
  /** Where the arrow ends; nothing where way-points say where it goes. */
  tip: Point | null
  /** Where a hand pulls at it. */
  knob: Point
  /** To which side it goes. */
  heading: Point
  /** It has no speed: what there is to pull is shown only when it is asked for. */
  still: boolean
}

/** As it lies on the screen. A slow one has an arrow as well. */
function seenAs(one: Moving, now: Point | undefined, view: View, size: Size): Seen {
  const start = toScreen(view, size, one.center)
  const radius = one.radius * view.scale
  const end = tipOf(one)
  const [x, y] = end ? toScreen(view, size, end) : start
  const [dx, dy] = [x - start[0], y - start[1]]
  const length = Math.hypot(dx, dy)
  const still = length === 0
  const by = still ? 0 : Math.max(1, (radius + BEYOND) / length)
  const tip: Point = still ? [start[0] + radius + BEYOND, start[1]] : [start[0] + by * dx, start[1] + by * dy]
  const heading: Point = still ? [1, 0] : [dx / length, dy / length]
  const knob: Point = still ? tip : [tip[0] + (KNOB + 2) * heading[0], tip[1] + (KNOB + 2) * heading[1]]
  return { start, now: now ? toScreen(view, size, now) : start, radius, tip: end ? tip : null, knob, heading, still }
}

const apart = (a: Point, b: Point): number => Math.hypot(a[0] - b[0], a[1] - b[1])

/** What of the moving obstacles lies under a point of the screen: an arrow's tip, or a disc where it is now or begins. */
export function hitMoving(
  scene: GridScene,
  now: readonly Point[] | null,
  view: View,
  size: Size,
  at: Point,
  selection: Selection | null,
  coarse: boolean,
): Handle | null {
  const reach = coarse ? COARSE : NEAR
  let best: { handle: Handle; rank: number } | null = null
  const offer = (handle: Handle, rank: number): void => {
    if (rank < (best?.rank ?? Infinity)) best = { handle, rank }
  }
  movingOf(scene).forEach((one, index) => {
    const { start, now: here, radius, tip, knob, still } = seenAs(one, now?.[index], view, size)
    const selected = same(selection, { kind: 'moving', index })
    // What is selected goes first; a finger takes hold of no other's arrow.
    const least = selected ? -1e6 : 0
    const aim = Math.min(apart(knob, at), tip ? apart(tip, at) : Infinity)
    if (tip && (selected || (!coarse && !still)) && aim <= reach) offer({ kind: 'aim', index }, least + aim)
    for (const disc of [here, start])
      if (apart(disc, at) <= Math.max(radius + 3, reach)) offer({ kind: 'moving', index }, least + apart(disc, at))
  })
  return (best as { handle: Handle } | null)?.handle ?? null
}

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

function circle(context: CanvasRenderingContext2D, [x, y]: Point, radius: number): void {
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
  context.font = '600 11px Inter, "Segoe UI", system-ui, sans-serif'
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
