import type { GridScene, Moving, Point } from 'forage-lab'
import { tipOf } from '../scene/aiming'
import { type Handle, same, type Selection } from '../scene/edits'
import { movingOf } from '../scene/moving'
import { type Size, toScreen, type View } from './view'

/** An arrow reaches at least this far out of its disc, in pixels. */
const BEYOND = 15
/** How near a hand must come, in pixels. */
const [NEAR, COARSE] = [11, 24]
export const KNOB = 5.5

/** A moving obstacle as it lies on the screen. */
export interface Seen {
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
export function seenAs(one: Moving, now: Point | undefined, view: View, size: Size): Seen {
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

export const apart = (a: Point, b: Point): number => Math.hypot(a[0] - b[0], a[1] - b[1])

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

/** The event at a point of the screen: of several the nearest, and at one place the latest. */
export function eventAt(events: readonly Point[], view: View, size: Size, at: Point, coarse: boolean): number | null {
  let best = { index: -1, from: coarse ? COARSE : NEAR }
  events.forEach((place, index) => {
    const from = apart(toScreen(view, size, place), at)
    if (from <= best.from) best = { index, from }
  })
  return best.index < 0 ? null : best.index
}
