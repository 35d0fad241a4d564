import type { Catalogue, Layer, Look, Outcome, Planner, Scene } from 'forage-lab'
import { met } from '../../../catalogue/parameters'
import { layerOf, type Names, namesOf, PLAIN } from '../../../render/looks'
import { movingOf } from '../../../scene/moving'
import { stopsOf } from '../../../scene/stops'
import { drawArrows } from '../../../render/canvas/arrows'
import { Cells } from '../../../render/canvas/cells'
import { drawRobots, drawTubes, own } from '../../../render/canvas/driven'
import type { Field } from '../../../render/canvas/field'
import { drawDiscs, drawEnds, drawGrid } from '../../../render/canvas/ground'
import { drawHappenings } from '../../../render/canvas/events'
import { insideCells } from '../../../render/canvas/overlap-cells'
import { drawLayers, drawPath, isNear, type Layers } from '../../../render/canvas/layers'
import { drawMovers, placesNow, placesOf } from '../../../render/canvas/movers'
import type { Pen } from '../../../render/canvas/pen'
import { drawRaster } from '../../../render/canvas/raster'
import { drawStops, placesOf as placesOfStops } from '../../../render/canvas/stops'
import type { Report } from '../../../engine/protocol'
import type { LaneRun } from './lane.svelte'
import { drawRoom, flattened, projected, seen, type Side } from '../../../render/space/projection'

/** How much of a field is left beneath what is only drawn from near. */
const BENEATH = 0.65

/** What is drawn of a racer. */
export interface Subject {
  scene: Scene
  catalogue: Catalogue
  planner: Planner | undefined
  run: LaneRun | null
  picture: Report | null
  outcome: Outcome | null
  side: Side
  names: { start: string; goal: string }
}

/** The layers that are on without being asked for. */
export const shownOf = (planner: Planner | undefined, scene: Scene, values: LaneRun['parameters'] = {}): Layer[] =>
  (planner?.layers ?? []).filter(
    ({ on, when, kinds }) => on && (kinds?.includes(scene.kind) ?? true) && met(when, planner?.parameters ?? [], scene.kind, values),
  )

/** A racer's results have its own colour: the one that its lane has for the best. */
function namesIn({ palette }: Pen, catalogue: Catalogue, planner: Planner | undefined): Names {
  const { layers, shapes } = namesOf(catalogue, planner)
  const [light, dark] = [palette.get('--best'), palette.get('--best')]
  return {
    shapes,
    layers: layers.map((layer) => (layer.look.result ? { ...layer, look: { ...layer.look, color: { light, dark } } } : layer)),
  }
}

const exactOf = (catalogue: Catalogue): Look => layerOf(catalogue, null, 'exact')?.look ?? PLAIN

/** Draws a racer as the stage would, read-only. */
export class Painter {
  private readonly cells: Cells
  /** A frame that was projected, and what from. */
  private last: { picture: Report; side: Side; layers: Layers } | null = null

  constructor(
    readonly field: Field,
    changed: () => void,
  ) {
    this.cells = new Cells(changed)
  }

  draw(pen: Pen, subject: Subject): void {
    const { context, size, palette } = pen
    context.fillStyle = palette.get('--stage')
    context.fillRect(0, 0, size.width, size.height)
    // Whose run is shown may not be the one that is chosen any more.
    const { catalogue, run } = subject
    const planner = catalogue.planners.find(({ name }) => name === run?.planner) ?? subject.planner
    if (subject.scene.kind === 'arm') this.inSpace(pen, { ...subject, planner })
    else this.inThePlane(pen, { ...subject, planner })
  }

  private inSpace(pen: Pen, { scene, catalogue, planner, run, picture, side, names }: Subject): void {
    if (scene.kind !== 'arm') return
    const skeleton = run?.skeleton ?? []
    const flat = flattened(scene, skeleton, side)
    const shown = shownOf(planner, scene, run?.parameters)
    drawRoom(pen, scene, skeleton, side)
    if (picture) {
      if (this.last?.picture !== picture || this.last.side !== side) this.last = { picture, side, layers: projected(picture, side) }
      drawLayers(pen, this.last.layers, namesIn(pen, catalogue, planner), (role) => shown.some((layer) => layer.role === role), flat, {})
    }
    const tip = run && picture ? run.exact?.tip_path : undefined
    if (tip) drawPath(pen, tip.map(seen(side)), exactOf(catalogue))
    drawEnds(pen, flat, false, null, null, null, names)
  }

  private inThePlane(pen: Pen, subject: Subject): void {
    const { scene, catalogue, planner, run, picture, names } = subject
    const shown = shownOf(planner, scene, run?.parameters)
    const drawn = namesIn(pen, catalogue, planner)
    const on = (role: string): boolean => shown.some((layer) => layer.role === role)
    const touring = scene.kind === 'tour' || (planner?.stops ?? false)
    this.field.draw(pen)
    if (picture) for (const field of picture.fields) if (on(field.role)) drawRaster(pen, field, isNear(picture, drawn, on) ? BENEATH : 1)
    if (scene.kind === 'grid') this.cells.draw(pen, scene, true)
    drawGrid(pen, scene, scene.kind !== 'grid' && scene.kind !== 'function')
    if (scene.kind === 'discs') drawDiscs(pen, scene, null)
    if (picture) drawLayers(pen, picture, drawn, on, scene, { own, drawTubes, drawArrows, insideCells })
    if (picture && run?.exact) drawPath(pen, run.exact.path, exactOf(catalogue))
    const places = picture ? placesOfStops(picture, drawn, stopsOf(scene).length) : null
    drawStops(pen, scene, { places, selection: null, hover: null, blamed: null, touring })
    this.moving(pen, subject)
    if (scene.kind !== 'function' && scene.kind !== 'arm') drawEnds(pen, scene, touring, null, null, null, names)
    if (picture) drawRobots(pen, picture, drawn, () => true)
  }

  /** What moves is where it is at the racer's time. */
  private moving(pen: Pen, { scene, catalogue, planner, picture, outcome }: Subject): void {
    if (scene.kind !== 'grid' || movingOf(scene).length === 0) return
    const drawn = namesOf(catalogue, planner)
    const now = picture && placesNow(picture, drawn, movingOf(scene).length)
    drawMovers(pen, scene, { now, quiet: now !== null && (picture?.iteration ?? 0) > 0, selection: null, hover: null, blamed: null })
    if (!picture) return
    drawHappenings(
      pen,
      placesOf(picture, drawn, 'event'),
      (index) => planner?.events.find(({ name }) => name === outcome?.events?.[index]?.kind)?.tone,
    )
  }
}
