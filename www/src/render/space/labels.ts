import type { Cuboid, Point3 } from 'forage-lab'
import { space } from '../../locales/en/space'
import { plus, times } from '../../scene/vector'
import { plate } from '../canvas/ground'
import { small } from '../canvas/letters'
import type { CanvasPen, Pen } from '../canvas/pen'
import { tick } from '../view'
import { ticks } from './room'
import type { Camera } from './camera'

/** Numbers lie at least so far apart, in pixels, and so far from their edge. */
const APART = 46
const BESIDE = 15
const TITLE = 34
const LETTER = 7

/** From where something is seen, and where it is seen then: by a camera, or in parallel projection. */
export type Eye = Pick<Camera, 'eye'> & { project(point: Point3): { x: number; y: number } | null }

/** An edge of the workspace along an axis. */
interface Edge {
  axis: 0 | 1 | 2
  from: Point3
  to: Point3
}

/** The numbers along three edges of the workspace, in metres: on the floor the ones nearest to the eye, and an upright one at the side. */
export function drawAxes(pen: Pen, camera: Eye, box: Cuboid): void {
  const { context, palette } = pen
  context.font = small()
  context.textBaseline = 'middle'
  context.setLineDash([])
  const middle = camera.project([(box.min[0] + box.max[0]) / 2, (box.min[1] + box.max[1]) / 2, (box.min[2] + box.max[2]) / 2])
  if (!middle) return
  for (const { axis, from, to } of edges(camera, box)) {
    const [a, b] = [camera.project(from), camera.project(to)]
    if (!a || !b) continue
    const length = Math.hypot(b.x - a.x, b.y - a.y)
    // Seen from its end an axis has no numbers.
    if (length < APART) continue
    // Square to the edge, away from the middle.
    let [nx, ny] = [-(b.y - a.y) / length, (b.x - a.x) / length]
    if (nx * ((a.x + b.x) / 2 - middle.x) + ny * ((a.y + b.y) / 2 - middle.y) < 0) [nx, ny] = [-nx, -ny]
    context.textAlign = Math.abs(nx) < 0.35 ? 'center' : nx > 0 ? 'left' : 'right'
    const step = tick(length / (to[axis] - from[axis]), APART)
    context.strokeStyle = palette.get('--line-strong')
    const digits = Math.max(1, -Math.floor(Math.log10(step)))
    for (const value of ticks(from[axis], to[axis], step)) {
      const at: Point3 = [...from]
      at[axis] = value
      const seen = camera.project(at)
      if (!seen) continue
      context.lineWidth = 1
      context.strokeStyle = palette.get('--line-strong')
      context.beginPath()
      context.moveTo(seen.x, seen.y)
      context.lineTo(seen.x + 5 * nx, seen.y + 5 * ny)
      context.stroke()
      context.fillStyle = palette.get('--ink-2')
      plate(
        context,
        palette.get('--stage'),
        value
          .toFixed(digits)
          .replace(/^-(?=0\.?0*$)/, '')
          .replace('-', '−'),
        seen.x + BESIDE * nx,
        seen.y + BESIDE * ny,
      )
    }
    context.font = `italic 600 13px Georgia, 'Times New Roman', serif`
    context.fillStyle = palette.get('--ink')
    const title = `${space.axes[axis]} / ${space.unit}`
    plate(context, palette.get('--stage'), title, ...inside(pen, title, (a.x + b.x) / 2 + TITLE * nx, (a.y + b.y) / 2 + TITLE * ny))
    context.font = small()
  }
}

/** Where a text is seen whole. */
function inside({ context, size }: Pen, text: string, x: number, y: number): [number, number] {
  // A file does not know how wide its letters are.
  const width = ('measureText' in context ? (context as CanvasPen['context']).measureText(text).width : LETTER * text.length) + 6
  const before = { left: 0, center: width / 2, right: width }[context.textAlign as 'left' | 'center' | 'right']
  return [Math.min(Math.max(x, before), size.width - width + before), Math.min(Math.max(y, 10), size.height - 10)]
}

function edges(camera: Eye, { min, max }: Cuboid): Edge[] {
  const near = (axis: 0 | 1): number =>
    Math.abs(camera.eye[axis] - min[axis]) < Math.abs(camera.eye[axis] - max[axis]) ? min[axis] : max[axis]
  const [x, y, floor] = [near(0), near(1), min[2]]
  const floors: Edge[] = [
    { axis: 0, from: [min[0], y, floor], to: [max[0], y, floor] },
    { axis: 1, from: [x, min[1], floor], to: [x, max[1], floor] },
  ]
  const seen = (edge: Edge): { x: number; y: number } => camera.project(times(plus(edge.from, edge.to), 0.5)) ?? { x: 0, y: 0 }
  const uprights = [min[0], max[0]]
    .flatMap((px) => [min[1], max[1]].map((py): Edge => ({ axis: 2, from: [px, py, floor], to: [px, py, max[2]] })))
    .sort((one, other) => seen(one).x - seen(other).x)
  // Its numbers must not stand among those of the floor's steeper edge.
  const [steep] = [...floors].sort((one, other) => slope(camera, other) - slope(camera, one))
  const meets = (edge: Edge | undefined): boolean =>
    [steep?.from, steep?.to].some((end) => end?.[0] === edge?.from[0] && end?.[1] === edge?.from[1])
  const upright = meets(uprights[0]) ? uprights.at(-1) : uprights[0]
  return upright ? [...floors, upright] : floors
}

/** How steep an edge is on the screen. */
function slope(camera: Eye, { from, to }: Edge): number {
  const [a, b] = [camera.project(from), camera.project(to)]
  return a && b ? Math.abs(a.y - b.y) / Math.max(1, Math.abs(a.x - b.x)) : 0
}
