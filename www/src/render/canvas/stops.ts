import { fontOf } from './letters'
import type { Scene } from 'forage-lab'
import { ends, type Handle, same, type Selection } from '../../scene/edits'
import { stopsOf } from '../../scene/stops'
import type { Context, Pen } from './pen'
import { toScreen } from '../view'

/** A disc holds a number of two digits. */
const DISC = 9.5
const DOT = 4
/** Discs may overlap by a little: their rims tell them apart. */
const ROOM = 2 * DISC - 3
/** More numbers than these at once say nothing. */
const MOST = 90
/** The share of stops that must have room for numbers. */
const ENOUGH = 0.7
/** More dots than these are smaller. */
const MANY = 400

export interface Marks {
  places: readonly number[] | null
  selection: Selection | null
  hover: Handle | null
  blamed: Selection | null
  /** The planner calls at them. */
  touring: boolean
}

interface Seen {
  index: number
  x: number
  y: number
  /** How far the nearest other one is. */
  room: number
}

function seen({ view, size }: Pen, scene: Scene): Seen[] {
  const found = stopsOf(scene).flatMap((stop, index) => {
    const [x, y] = toScreen(view, size, stop)
    const inside = x > -DISC && y > -DISC && x < size.width + DISC && y < size.height + DISC
    return inside ? [{ index, x, y, room: Infinity }] : []
  })
  // Beyond that there are no numbers, and nobody asks.
  if (found.length > MOST) return found.map((stop) => ({ ...stop, room: 0 }))
  for (const a of found) for (const b of found) if (a !== b) a.room = Math.min(a.room, Math.hypot(a.x - b.x, a.y - b.y))
  // A number here and there would be more puzzling than none.
  const roomy = found.filter(({ room }) => room >= ROOM).length
  return roomy >= ENOUGH * found.length ? found : found.map((stop) => ({ ...stop, room: 0 }))
}

/** A tour numbers the stops as it calls at them; without one they have the scene's numbers, lighter. */
export function drawStops(pen: Pen, scene: Scene, { places, selection, hover, blamed, touring }: Marks): void {
  const { context, palette } = pen
  const stops = seen(pen, scene)
  const dot = stops.length > MANY ? DOT - 1.5 : DOT
  // Where a way begins or ends, there is a mark already.
  const hidden = touring || scene.kind !== 'grid' ? [] : ends(scene).map(({ at }) => toScreen(pen.view, pen.size, at))
  context.setLineDash([])
  context.textAlign = 'center'
  context.textBaseline = 'middle'
  // The first lie on top.
  for (const { index, x, y, room } of stops.reverse()) {
    if (hidden.some((end) => Math.hypot(x - end[0], y - end[1]) < DOT)) continue
    const handle: Selection = { kind: 'stop', index }
    const [wrong, place] = [same(blamed, handle), places?.[index] ?? -1]
    const radius = room >= ROOM ? DISC : dot
    const colour = palette.get(wrong ? '--danger' : places ? '--best' : touring ? '--ink-2' : '--line-strong')
    const ring = (more: number, token: string): void => {
      circle(context, x, y, radius + more)
      context.lineWidth = 2
      context.strokeStyle = palette.get(token)
      context.stroke()
    }
    circle(context, x, y, radius)
    context.fillStyle = palette.get(wrong ? '--danger-soft' : '--stage')
    context.fill()
    context.strokeStyle = colour
    context.lineWidth = places ? 1.75 : 1.25
    context.stroke()
    if (radius === DISC) {
      const label = String((places ? place : index) + 1)
      context.font = fontOf(`${places ? 600 : 500} ${label.length > 2 ? 9 : 11}px`)
      context.fillStyle = palette.get(wrong ? '--danger' : places ? '--stop' : '--ink-2')
      context.fillText(label, x, y + 0.5)
    }
    if (place === 0) ring(3.25, wrong ? '--danger' : '--best')
    if (hover?.kind === 'stop' && hover.index === index) ring(place === 0 ? 6.5 : 4, '--line-strong')
    if (same(selection, handle)) ring(place === 0 ? 6.5 : 4, '--focus')
  }
}

function circle(context: Context, x: number, y: number, radius: number): void {
  context.beginPath()
  context.arc(x, y, radius, 0, 2 * Math.PI)
}
