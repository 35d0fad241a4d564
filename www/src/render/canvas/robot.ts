import { fontOf } from './letters'
import type { Point } from 'forage-lab'
import type { Pose, Track } from '../../scene/track'
import type { Pen } from './pen'
import { rise, toScreen } from '../view'

/** The robot is never drawn smaller than this, in pixels along its heading. */
const LEAST = 7
/** Rows of the track that lie nearer to each other than this aren't told apart. */
const APART = 0.75

interface Names {
  touches: string
  stopped: string
}

/** The path, the track behind the robot, where it touched or stopped short, and the robot itself. */
export function drawDrive(pen: Pen, track: Track, time: number, path: readonly Point[], names: Names): void {
  const { context, palette, view } = pen
  const { outcome, outline } = track.drive
  context.setLineDash([])
  context.lineJoin = context.lineCap = 'round'
  line(pen, path)
  stroke(pen, '--best', 2)
  const now = track.at(time)
  const behind = Array.from({ length: track.row(time) + 1 }, (_, row) => track.pose(row))
  line(
    pen,
    [...behind, now].map(({ x, y }): Point => [x, y]),
  )
  context.globalAlpha = 0.16
  stroke(pen, '--robot', Math.max(2, outline.width * view.scale))
  context.globalAlpha = 1
  stroke(pen, '--robot', 2.25)
  if (outcome.touched_at) cross(pen, outcome.touched_at, names.touches)
  if (!outcome.arrived) {
    const { x, y } = track.pose(track.times.length - 1)
    cross(pen, [x, y], names.stopped)
  }
  const touching = track.value('clearance', track.row(time)) < 0
  body(pen, now, outline, palette.get(touching ? '--danger' : '--robot'), palette.get(touching ? '--danger-soft' : '--robot-soft'))
}

function line({ context, view, size }: Pen, points: readonly Point[]): void {
  context.beginPath()
  let last: Point = [-Infinity, -Infinity]
  points.forEach((point, at) => {
    const [x, y] = toScreen(view, size, point)
    if (at > 0 && at < points.length - 1 && Math.hypot(x - last[0], y - last[1]) < APART) return
    last = [x, y]
    if (at === 0) context.moveTo(x, y)
    else context.lineTo(x, y)
  })
}

function stroke({ context, palette }: Pen, colour: string, width: number): void {
  context.strokeStyle = palette.get(colour)
  context.lineWidth = width
  context.stroke()
}

/** The outline with an arrow head where it looks to. */
function body(
  { context, view, size }: Pen,
  { x, y, heading }: Pose,
  outline: { length: number; width: number },
  edge: string,
  fill: string,
): void {
  const [left, top] = toScreen(view, size, [x, y])
  const by = Math.max(view.scale, LEAST / outline.length)
  const [along, across] = [(outline.length * by) / 2, (outline.width * by) / 2]
  context.save()
  context.translate(left, top)
  context.rotate(-rise(view) * heading)
  context.beginPath()
  context.roundRect(-along, -across, 2 * along, 2 * across, Math.min(3, across / 2))
  context.fillStyle = fill
  context.strokeStyle = edge
  context.lineWidth = 2
  context.fill()
  context.stroke()
  context.beginPath()
  context.moveTo(along * 0.72, 0)
  context.lineTo(-along * 0.1, across * 0.6)
  context.lineTo(-along * 0.1, -across * 0.6)
  context.closePath()
  context.fillStyle = edge
  context.fill()
  context.restore()
}

/** A place where something went wrong. */
function cross({ context, view, size, palette }: Pen, at: Point, name: string): void {
  const [x, y] = toScreen(view, size, at)
  context.beginPath()
  context.arc(x, y, 10, 0, 2 * Math.PI)
  for (const side of [-1, 1]) {
    context.moveTo(x - 5, y - 5 * side)
    context.lineTo(x + 5, y + 5 * side)
  }
  context.strokeStyle = palette.get('--stage')
  context.lineWidth = 5
  context.stroke()
  context.strokeStyle = palette.get('--danger')
  context.lineWidth = 2.25
  context.stroke()
  const leftwards = x > size.width - 120
  context.font = fontOf('600 12px')
  context.textAlign = leftwards ? 'right' : 'left'
  context.textBaseline = 'middle'
  context.lineWidth = 4
  context.strokeStyle = palette.get('--stage')
  context.strokeText(name, x + (leftwards ? -15 : 15), y)
  context.fillStyle = palette.get('--danger')
  context.fillText(name, x + (leftwards ? -15 : 15), y)
}
