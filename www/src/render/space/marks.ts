import { fontOf } from '../canvas/letters'
import type { ArmScene, Point3 } from 'forage-lab'
import { whereIs } from '../../scene/arm'
import type { Selection } from '../../scene/edits'
import { HANDLE, plate } from '../canvas/ground'
import { arrow, MANY, SMALL } from '../canvas/inspection'
import { applyStyle, isMarked, marked, type CanvasPen } from '../canvas/pen'
import type { Detail, Display } from '../display'
import { faceOf, facing, type Grip, isHidden, liftAt } from './handles'
import type { Camera } from './camera'

/** How much of a mark is seen that something stands before. */
const BEHIND = 0.4
/** Half the side of a face's handle, and the length of the lifting arrow's head. */
const [KNOB, HEAD] = [5.5, 6]

export interface Marked {
  scene: ArmScene
  selection: Selection | null
  hover: Grip | null
  held: boolean
  blamed: Selection | null
  words: Display['words']
}

/** Start and goal as in the plane, each on a stem that stands on the floor. */
export function drawEnds(pen: CanvasPen, camera: Camera, { scene, selection, hover, blamed, words }: Marked): void {
  const { context, palette, size } = pen
  for (const kind of ['start', 'goal'] as const) {
    const at = scene[kind]
    const seen = camera.project(at)
    if (!seen) continue
    const colour = palette.get(blamed?.kind === kind ? '--danger' : '--ink')
    context.globalAlpha = isHidden(scene, camera, at) ? BEHIND : 1
    stem(pen, camera, at, scene.workspace.min[2])
    context.setLineDash([])
    context.beginPath()
    context.arc(seen.x, seen.y, HANDLE, 0, 2 * Math.PI)
    context.fillStyle = kind === 'start' ? colour : palette.get('--stage')
    context.strokeStyle = colour
    context.lineWidth = 2
    context.fill()
    context.stroke()
    if (kind === 'goal') {
      context.beginPath()
      context.arc(seen.x, seen.y, 2.5, 0, 2 * Math.PI)
      context.fillStyle = colour
      context.fill()
    }
    context.globalAlpha = 1
    const ring = selection?.kind === kind ? '--focus' : hover?.kind === kind ? '--line-strong' : null
    if (ring) circle(pen, seen.x, seen.y, HANDLE + 4, palette.get(ring))
    context.font = fontOf('600 12px')
    context.fillStyle = colour
    context.textBaseline = 'middle'
    const right = seen.x < size.width / 2
    context.textAlign = right ? 'right' : 'left'
    plate(context, palette.get('--stage'), words[kind], seen.x + (right ? -13 : 13), seen.y - 10)
  }
}

/** Says how high a point is. */
function stem({ context, palette }: CanvasPen, camera: Camera, at: Readonly<Point3>, floor: number): void {
  const [top, foot] = [camera.project(at), camera.project([at[0], at[1], floor])]
  if (!top || !foot) return
  context.setLineDash([2, 3])
  context.lineWidth = 1.25
  context.strokeStyle = palette.get('--ink-2')
  context.beginPath()
  context.moveTo(top.x, top.y)
  context.lineTo(foot.x, foot.y)
  context.stroke()
  context.setLineDash([])
  context.beginPath()
  context.ellipse(foot.x, foot.y, 3, 1.5, 0, 0, 2 * Math.PI)
  context.fillStyle = palette.get('--ink-2')
  context.fill()
}

function circle({ context }: CanvasPen, x: number, y: number, radius: number, colour: string): void {
  context.beginPath()
  context.arc(x, y, radius, 0, 2 * Math.PI)
  context.lineWidth = 2
  context.strokeStyle = colour
  context.stroke()
}

/** What the selected object can be taken hold of by: a cuboid's faces, and an arrow upwards. */
export function drawHandles(pen: CanvasPen, camera: Camera, { scene, selection, hover, held }: Marked): void {
  const { context, palette } = pen
  if (!selection) return
  const cuboid = selection.kind === 'cuboid' ? scene.cuboids[selection.index] : undefined
  context.setLineDash([])
  if (cuboid) {
    for (const face of facing(cuboid, camera)) {
      const seen = camera.project(faceOf(cuboid, face))
      if (!seen) continue
      const meant = hover?.kind === 'face' && hover.axis === face.axis && hover.side === face.side
      context.beginPath()
      context.arc(seen.x, seen.y, KNOB + (meant ? 1.5 : 0), 0, 2 * Math.PI)
      context.fillStyle = palette.get(meant ? '--focus' : '--surface')
      context.strokeStyle = palette.get('--focus')
      context.lineWidth = 2
      context.fill()
      context.stroke()
    }
  }
  const at = liftAt(scene, selection, camera)
  if (at) lift(pen, at, hover?.kind === 'lift')
  if (selection.kind === 'base') {
    const seen = camera.project(scene.arm.base.position)
    if (seen) circle(pen, seen.x, seen.y, HANDLE + 4, palette.get('--focus'))
  }
  const middleOf = held && whereIs(scene, selection)
  if (middleOf) told(pen, camera, middleOf, cuboid ? cuboid.max : middleOf)
}

/** Where it is while it is held. */
function told({ context, palette }: CanvasPen, camera: Camera, at: Readonly<Point3>, top: Readonly<Point3>): void {
  const seen = camera.project([at[0], at[1], top[2]])
  if (!seen) return
  context.font = fontOf('600 12px')
  context.textAlign = 'left'
  context.textBaseline = 'middle'
  context.fillStyle = palette.get('--ink')
  plate(context, palette.get('--stage'), at.map((value) => value.toFixed(3).replace('-', '−')).join('  '), seen.x + 16, seen.y - 22)
}

function lift({ context, palette }: CanvasPen, [x, y]: readonly [number, number], meant: boolean): void {
  context.strokeStyle = palette.get('--stage')
  context.fillStyle = palette.get('--focus')
  context.lineJoin = 'round'
  context.beginPath()
  context.moveTo(x, y - 13)
  context.lineTo(x + HEAD, y - 4)
  context.lineTo(x + 2, y - 4)
  context.lineTo(x + 2, y + 4)
  context.lineTo(x + HEAD, y + 4)
  context.lineTo(x, y + 13)
  context.lineTo(x - HEAD, y + 4)
  context.lineTo(x - 2, y + 4)
  context.lineTo(x - 2, y - 4)
  context.lineTo(x - HEAD, y - 4)
  context.closePath()
  context.lineWidth = meant ? 5 : 3
  context.stroke()
  context.fill()
}

/** What was looked at closer: its points, and arrows. */
export function drawDetails(pen: CanvasPen, camera: Camera, scene: ArmScene, details: readonly Detail[]): void {
  const { context } = pen
  for (const { look, shape, vertices } of [...details].sort((a, b) => a.look.order - b.look.order)) {
    applyStyle(pen, look)
    const seen = vertices.map((vertex) => camera.project(vertex))
    if (shape === 'points') {
      const small = vertices.length > MANY ? { ...look, point: Math.min(look.point, SMALL) } : look
      seen.forEach((at, index) => {
        const vertex = vertices[index]
        if (!at || !vertex) return
        context.globalAlpha = look.opacity[0] * (isHidden(scene, camera, vertex) ? BEHIND : 1)
        if (isMarked(look)) marked(pen, small, at.x, at.y)
        else {
          context.beginPath()
          context.arc(at.x, at.y, look.point / 2 + 1, 0, 2 * Math.PI)
          if (look.dash) context.stroke()
          else context.fill()
        }
      })
      continue
    }
    context.globalAlpha = look.opacity[0]
    for (let at = 0; at + 1 < seen.length; at += shape === 'polyline' ? 1 : 2) {
      const [from, to] = [seen[at], seen[at + 1]]
      if (!from || !to) continue
      if (shape === 'segments') arrow(context, [from.x, from.y], [to.x, to.y])
      else {
        context.beginPath()
        context.moveTo(from.x, from.y)
        context.lineTo(to.x, to.y)
        context.stroke()
      }
    }
  }
  context.globalAlpha = 1
}

/** A ring about a node. */
export function drawNode(pen: CanvasPen, camera: Camera, at: Readonly<Point3> | null, chosen: boolean): void {
  const seen = at && camera.project(at)
  if (!seen) return
  pen.context.setLineDash([])
  circle(pen, seen.x, seen.y, chosen ? 8 : 7, pen.palette.get(chosen ? '--focus' : '--line-strong'))
}
