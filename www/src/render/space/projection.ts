import type { ArmScene, Cuboid, DiscsScene, Point, Point3 } from 'forage-lab'
import type { Layers } from '../frame'
import { type Path, type Pen, pathOf } from '../canvas/pen'
import { dot } from '../../scene/vector'
import { toScreen } from '../view'
import { basis, type Orbit } from './orbit'

/* Arms in the plane: seen in parallel projection, as in a race and in a drawing. */

/** From where it is seen, in degrees. */
export type Angles = Pick<Orbit, 'azimuth' | 'elevation'>

/** A point as it is seen from a side, in metres. */
export function seen(side: Angles): (point: Point3) => Point {
  const [right, up] = basis(side)
  return (point) => [dot(right, point), dot(up, point)]
}

const corners = ({ min, max }: Cuboid): Point3[] =>
  Array.from({ length: 8 }, (_, at): Point3 => [at & 1 ? max[0] : min[0], at & 2 ? max[1] : min[1], at & 4 ? max[2] : min[2]])

/** The scene as a picture in the plane: what stands in it is drawn apart. */
export function flattened(scene: ArmScene, skeleton: readonly Point3[], side: Angles): DiscsScene {
  const to = seen(side)
  const all = [...corners(scene.workspace), ...skeleton].map(to)
  const [x, y] = [all.map((at) => at[0]), all.map((at) => at[1])]
  const bounds = { min: [Math.min(...x), Math.min(...y)] as Point, max: [Math.max(...x), Math.max(...y)] as Point }
  return {
    format: 'forage-scene',
    version: 1,
    kind: 'discs',
    name: scene.name,
    title: scene.title,
    bounds,
    start: to(scene.start),
    goal: to(scene.goal),
    discs: [],
  }
}

/** A frame's vertices as they are seen from a side. */
export function projected({ buffer, vertices, spans }: Layers, side: Angles): Layers {
  const [right, up] = basis(side)
  const copy = buffer.slice(0, 4 * (vertices + spans))
  const points = new Float32Array(copy, 0, vertices)
  for (let at = 0; at < vertices; at += 4) {
    const point: Point3 = [points[at] ?? 0, points[at + 1] ?? 0, points[at + 2] ?? 0]
    points[at] = dot(right, point)
    points[at + 1] = dot(up, point)
    points[at + 2] = 0
  }
  return { buffer: copy, vertices, spans }
}

/** A box's faces as corners in their order, with the axis and the side that each looks to. */
const FACES = [0, 1, 2].flatMap((axis) =>
  [0, 1].map((high) => {
    const [u, v] = [1 << ((axis + 1) % 3), 1 << ((axis + 2) % 3)]
    const base = high ? 1 << axis : 0
    return { axis, high, ring: [base, base | u, base | u | v, base | v] }
  }),
)

/** The room, what stands in it, and the arm at home. */
export function drawRoom(pen: Pen, scene: ArmScene, skeleton: readonly Point3[], side: Angles): void {
  const { context, palette } = pen
  const back = basis(side)[2]
  context.setLineDash([])
  context.lineJoin = context.lineCap = 'round'
  context.fillStyle = palette.get('--grid')
  context.globalAlpha = 0.45
  context.fill(faces(pen, scene.workspace, side, (_, axis, high) => axis === 2 && !high))
  context.globalAlpha = 1
  context.lineWidth = 1
  context.strokeStyle = palette.get('--axis')
  context.stroke(faces(pen, scene.workspace, side, () => true))
  drawArm(pen, scene, skeleton, side)
  const depth = ({ min, max }: Cuboid): number => dot(back, [min[0] + max[0], min[1] + max[1], min[2] + max[2]])
  for (const cuboid of [...scene.cuboids].sort((a, b) => depth(a) - depth(b))) {
    const visible = faces(pen, cuboid, side, (towards) => towards > 1e-9)
    context.fillStyle = palette.get('--disc')
    context.globalAlpha = 0.85
    context.fill(visible)
    context.globalAlpha = 1
    context.lineWidth = 1.25
    context.strokeStyle = palette.get('--disc-edge')
    context.stroke(visible)
  }
}

function faces(pen: Pen, box: Cuboid, side: Angles, shown: (towards: number, axis: number, high: boolean) => boolean): Path {
  const [to, back, all] = [seen(side), basis(side)[2], corners(box)]
  const path = pathOf(pen)
  for (const { axis, high, ring } of FACES) {
    if (!shown((high ? 1 : -1) * (back[axis] ?? 0), axis, high === 1)) continue
    ring.forEach((corner, at) => {
      const [x, y] = toScreen(pen.view, pen.size, to(all[corner] ?? box.min))
      if (at === 0) path.moveTo(x, y)
      else path.lineTo(x, y)
    })
    path.closePath()
  }
  return path
}

function drawArm({ context, palette, view, size }: Pen, scene: ArmScene, skeleton: readonly Point3[], side: Angles): void {
  const to = seen(side)
  const base = scene.arm.base.position
  const line = ([[base[0], base[1], scene.workspace.min[2]], ...skeleton] as Point3[]).map((point) => toScreen(view, size, to(point)))
  const reach = scene.arm.joints.reduce((sum, { a, d }) => sum + Math.abs(a) + Math.abs(d), 0)
  context.globalAlpha = 0.5
  context.strokeStyle = context.fillStyle = palette.get('--robot')
  context.lineWidth = Math.max(3, 0.035 * reach * view.scale)
  context.beginPath()
  for (const [at, [x, y]] of line.entries()) {
    if (at === 0) context.moveTo(x, y)
    else context.lineTo(x, y)
  }
  context.stroke()
  context.globalAlpha = 1
}
