import { Group } from 'three'
import type { Look, Point3 } from 'forage-lab'
import { piecesOf } from '../canvas/layers'
import type { Palette } from '../palette'
import { lookBeside, type Names, PLAIN, resultOf } from '../looks'
import { type Layers as Drawing, spansOf, verticesOf } from '../frame'
import { colourOf } from './colors'
import type { Overlay } from '../display'
import { Dots } from './dots'
import { Strokes, vertices } from './strokes'

/** No layer's key begins like this. */
const OVERLAY = '/'

type Drawn = { role: string; look: Look }

/** What a planner has drawn, a kind of lines and one of points for each layer. */
export class Layers {
  readonly group = new Group()
  private readonly strokes = new Map<string, Strokes>()
  private readonly dots = new Map<string, Dots>()
  private readonly looks = new Map<string, Look>()
  /** What is shown now. */
  private shown = new Set<string>()

  /** The frame's numbers are copied: it goes back to the core. */
  show(frame: Drawing | null, names: Names, overlays: readonly Overlay[], on: (role: string) => boolean): void {
    for (const each of [...this.strokes.values(), ...this.dots.values()]) each.clear()
    this.shown = new Set()
    if (frame) {
      const [numbers, spans] = [verticesOf(frame), spansOf(frame)]
      for (const [number, layer] of names.layers.entries()) {
        const pieces = piecesOf(spans, number, names.shapes)
        if (pieces.length > 0 && on(layer.role)) this.shown.add(layer.role)
        for (const { shape, first, count } of pieces) {
          if (shape === 'points') this.dotsOf(layer).add(numbers, first, count)
          else if (shape === 'polyline' || shape === 'segments') this.strokesOf(layer).add(numbers, first, count, shape === 'polyline')
        }
      }
    }
    for (const [at, { points, look }] of overlays.entries()) {
      const role = `${OVERLAY}${at}`
      this.shown.add(role)
      this.strokesOf({ role, look }).add(vertices(points.map(([x, y, z = 0]) => [x, y, z])), 0, points.length, true)
    }
    for (const each of [...this.strokes.values(), ...this.dots.values()]) each.done()
    for (const [role, { group }] of this.strokes) group.visible = this.shown.has(role)
    for (const [role, { points }] of this.dots) points.visible = this.shown.has(role)
  }

  /** `left`: how much of what isn't the outcome, or highlighted, is left; `all`: of all. */
  paint(palette: Palette, left: number, all: number, highlighted: readonly string[] | null): void {
    const ground = colourOf(palette, '--stage')
    const result = resultOf([...this.shown].map((role) => ({ look: this.lookOf(role) })))
    for (const [role, strokes] of this.strokes) {
      const look = lookBeside(this.lookOf(role), result)
      // What is the outcome is not faded with the rest.
      const kept = highlighted ? highlighted.includes(role) : look.result !== undefined || role.startsWith(OVERLAY)
      strokes.look(look, { colour: colourOf(palette, look.color), ground, alpha: all * (kept ? 1 : left), result: kept })
    }
    for (const [role, dots] of this.dots) {
      const look = this.lookOf(role)
      dots.look(
        colourOf(palette, look.color),
        look.glyph,
        sizeOf(look),
        all * (highlighted?.includes(role) ? 1 : left) * Math.max(...look.opacity),
      )
    }
  }

  scale(each: number): void {
    for (const strokes of this.strokes.values()) strokes.scale(each)
  }

  /** A layer's points, while they are shown. */
  pointsOf(role: string): Dots | null {
    return this.shown.has(role) ? (this.dots.get(role) ?? null) : null
  }

  /** Where one of a layer's points is, shown or not. */
  place(role: string, index: number): Point3 | null {
    const dots = this.dots.get(role)
    if (!dots || index < 0 || index >= dots.count) return null
    return dots.at(index)
  }

  private lookOf(role: string): Look {
    return this.looks.get(role) ?? PLAIN
  }

  private strokesOf({ role, look }: Drawn): Strokes {
    this.looks.set(role, look)
    let found = this.strokes.get(role)
    if (!found) {
      found = new Strokes(look.order)
      this.strokes.set(role, found)
      this.group.add(found.group)
    }
    return found
  }

  private dotsOf({ role, look }: Drawn): Dots {
    this.looks.set(role, look)
    let found = this.dots.get(role)
    if (!found) {
      found = new Dots(look.order)
      this.dots.set(role, found)
      this.group.add(found.points)
    }
    return found
  }

  drop(): void {
    for (const each of [...this.strokes.values(), ...this.dots.values()]) each.drop()
  }
}

const sizeOf = ({ point }: Look): number => point + 0.5
