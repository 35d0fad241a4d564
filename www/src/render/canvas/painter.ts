import type { Item, Point, Scene } from 'forage-lab'
import { type Anchors, movedTo, orderOf, pointsOf } from '../anchors'
import type { Display, Ground, InSpace, SpaceState } from '../display'
import type { Frame, Layers } from '../frame'
import type { Names } from '../looks'
import { colorOf } from '../palette'
import { movingOf } from '../../scene/moving'
import { stopsOf } from '../../scene/stops'
import { toScreen } from '../view'
import type { Cells } from './cells'
import { drawDiscs, drawEnds, drawGrid } from './ground'
import { drawLayers, drawPath, isNear } from './layers'
import type { Angles } from '../space/projection'
import type { RoomPainter } from '../space/room-painter'
import type { CanvasPen, Pen } from './pen'
import { drawRaster } from './raster'

/** How much of the picture is left while it is not that of the scene, while something is looked at closer, and while the result is followed. */
const STALE = 0.22
const CLOSER = 0.45
const FOLLOWED = 0.55
/** How much of a field is left beneath what is only drawn from near. */
const BENEATH = 0.65

/** A frame, and what is known of it. */
export interface Present {
  frame: Frame
  names: Names
  anchors: Anchors
  /** As an arm's scene is seen from a side. */
  flat?: { angles: Angles; layers: Layers }
}

/** What not every scene needs: each part is loaded with the first one that does. */
const PARTS = {
  grids: () => import('./grids'),
  tours: () => import('./tours'),
  inspection: () => import('./inspection'),
  projection: () => import('../space/projection'),
  room: () => import('../space/room-painter'),
}
type Parts = { [P in keyof typeof PARTS]?: Awaited<ReturnType<(typeof PARTS)[P]>> }
const loading = new Map<keyof Parts, Promise<unknown>>()
const parts: Parts = {}

/** Resolves when no part is on its way any more. */
export async function partsLoaded(): Promise<void> {
  while (loading.size > Object.keys(parts).length) await Promise.all(loading.values())
}

/** Paints scenes and frames: on a canvas, or into a file. */
export class Painter {
  private cells: Cells | null = null
  private room: RoomPainter | null = null
  /** Nothing was missing. */
  private whole = true

  /** `soon`: the picture is to be painted again, for something has arrived; `tell`: whether space can be drawn. */
  constructor(
    private readonly soon: () => void,
    private readonly tell: (state: SpaceState) => void = () => undefined,
  ) {}

  drop(): void {
    this.room?.drop()
  }

  /** A part, if it is there; otherwise the picture is painted once more as soon as it is. */
  private part<P extends keyof Parts>(name: P): Parts[P] {
    if (!parts[name]) {
      this.whole = false
      const loaded = loading.get(name) ?? PARTS[name]().then((part) => Object.assign(parts, { [name]: part }))
      loading.set(name, loaded)
      // What cannot be loaded is asked for again with the next picture.
      loaded.then(this.soon, () => loading.delete(name))
    }
    return parts[name]
  }

  /** What lies beneath the frame. */
  beneath(pen: Pen, display: Display, heat: Ground | null): void {
    veil(pen, 0)
    if (heat && !display.hidden.includes('height')) drawGround(pen, heat)
    if (!isCovered(display.scene)) this.drawObstacles(pen, display)
  }

  /** All else; returns whether nothing was missing that is yet to come. */
  above(pen: Pen, display: Display, present: Present | null): boolean {
    this.whole = true
    if (isInSpace(display)) this.drawRoom(pen as CanvasPen, display, present)
    else if (display.scene.kind === 'arm') this.drawSpace(pen, display, present)
    else this.drawPlane(pen, display, present)
    return this.whole
  }

  /** The nearest of the points that are shown in space. */
  nearest(display: Display | null, at: Point, reach: number, layers: readonly string[]): Item | null {
    return (display && isInSpace(display) && this.room?.nearest(display, at, reach, layers)) || null
  }

  private drawRoom(pen: CanvasPen, display: Display & InSpace, present: Present | null): void {
    const part = this.part('room')
    if (!part) return
    this.room ??= new part.RoomPainter(this.tell, this.soon)
    this.room.draw(pen, display, display.fits ? (present?.frame ?? null) : null, present?.names ?? null)
  }

  private drawPlane(pen: Pen, display: Display, shown: Present | null): void {
    const { scene, hidden, fits, faded, details, cell } = display
    const present = fits ? shown : null
    const on = (role: string): boolean => !hidden.includes(role)
    const grids = scene.kind === 'grid' ? this.part('grids') : undefined
    const tours = stopsOf(scene).length > 0 ? this.part('tours') : undefined
    if (present) drawFields(pen, present, on)
    if (isCovered(scene)) this.drawObstacles(pen, display)
    if (present) {
      const { highlighted } = display
      const stands = (role: string): boolean => highlighted === null || highlighted.includes(role)
      const draw = (which: (role: string) => boolean): void =>
        drawLayers(pen, present.frame, inOwn(present, display), which, scene, { ...grids, ...tours })
      if (highlighted) {
        draw((role) => on(role) && !stands(role))
        veil(pen, CLOSER)
      }
      draw((role) => on(role) && stands(role))
      for (const { points, look } of display.overlays) drawPath(pen, points, look)
      if (details) {
        veil(pen, CLOSER)
        this.part('inspection')?.drawInspection(pen, details)
      }
      if (display.followed) veil(pen, FOLLOWED)
      // Not the picture of this scene: it must not look like one.
      if (faded) {
        veil(pen, STALE)
        this.drawObstacles(pen, display)
      }
    }
    if (scene.kind === 'grid' && cell) grids?.drawCell(pen, scene, cell)
    const fresh = faded ? null : present
    const order = fresh && on(roleOf(fresh, 'number')) ? orderOf(fresh.anchors, stopsOf(scene).length) : null
    tours?.drawStops(pen, scene, { ...display, places: order })
    this.drawMoving(pen, display, fresh, shown)
    if (scene.kind !== 'function' && scene.kind !== 'arm') drawEnds(pen, scene, display)
    // On top of all, start and goal included.
    if (fresh) grids?.drawRobots(pen, fresh.frame, fresh.names, on)
  }

  private drawObstacles(pen: Pen, { scene, hidden, blamed }: Display): void {
    const grids = scene.kind === 'grid' ? this.part('grids') : undefined
    if (scene.kind === 'grid' && grids) {
      this.cells ??= new grids.Cells(this.soon)
      this.cells.draw(pen, scene, !hidden.includes('margin'))
    }
    drawGrid(pen, scene, scene.kind !== 'grid' && scene.kind !== 'function')
    if (scene.kind === 'discs') drawDiscs(pen, scene, blamed)
  }

  /** Where obstacles begin and how they set out, and where something happened. */
  private drawMoving(pen: Pen, display: Display, present: Present | null, shown: Present | null): void {
    const { scene, hidden, tones, playing } = display
    const grids = scene.kind === 'grid' ? this.part('grids') : undefined
    if (scene.kind !== 'grid' || !grids) return
    const now = present && movedTo(present.anchors, movingOf(scene).length)
    const role = (shown && roleOf(shown, 'disc')) || 'moving'
    if (!hidden.includes(role)) grids.drawMovers(pen, scene, { ...display, now, quiet: playing && now !== null })
    if (present && tones) grids.drawEvents(pen, pointsOf(present.anchors.event), tones)
  }

  private drawSpace(pen: Pen, display: Display, shown: Present | null): void {
    const { scene, space, hidden, overlays, fits } = display
    const projection = this.part('projection')
    if (scene.kind !== 'arm' || !space || !projection) return
    const { angles, skeleton } = space
    const present = fits ? shown : null
    const flat = projection.flattened(scene, skeleton, angles)
    projection.drawRoom(pen, scene, skeleton, angles)
    if (present) {
      if (present.flat?.angles !== angles) present.flat = { angles, layers: projection.projected(present.frame, angles) }
      drawLayers(pen, present.flat.layers, inOwn(present, display), (role) => !hidden.includes(role), flat, {})
      const to = projection.seen(angles)
      for (const { points, look } of overlays)
        drawPath(
          pen,
          points.map(([x, y, z = 0]) => to([x, y, z])),
          look,
        )
    }
    drawEnds(pen, flat, display)
  }
}

const isInSpace = (display: Display): display is Display & InSpace => display.orbit !== undefined

/** Fields lie between the ground and the obstacles of a grid; arms are drawn otherwise. */
const isCovered = ({ kind }: Scene): boolean => kind === 'grid' || kind === 'arm'

/** The key of the frame's layer with this form. */
const roleOf = ({ names }: Present, form: 'disc' | 'number'): string => names.layers.find(({ look }) => look.glyph === form)?.role ?? ''

/** Of several results each has a colour of its own. */
function inOwn({ names }: Present, { theme: { best } }: Display): Names {
  if (best === undefined) return names
  return {
    ...names,
    layers: names.layers.map((layer) => (layer.look.result ? { ...layer, look: { ...layer.look, color: colorOf(best) } } : layer)),
  }
}

function drawFields(pen: Pen, { frame, names }: Present, on: (role: string) => boolean): void {
  const alpha = isNear(frame, names, on) ? BENEATH : 1
  for (const field of frame.fields) {
    if (!on(field.role)) continue
    pen.context.layer?.(field.role)
    drawRaster(pen, field, alpha)
  }
  pen.context.layer?.(null)
}

function drawGround({ context, view, size }: Pen, { bitmap, box }: Ground): void {
  const [left, bottom] = toScreen(view, size, box.min)
  const [right, top] = toScreen(view, size, box.max)
  context.imageSmoothingQuality = 'high'
  context.drawImage(bitmap, left, top, right - left, bottom - top)
}

/** So much of what is drawn is left. */
function veil({ context, palette, size }: Pen, left: number): void {
  context.save()
  context.globalAlpha = 1 - left
  context.fillStyle = palette.get('--stage')
  context.fillRect(0, 0, size.width, size.height)
  context.restore()
}
