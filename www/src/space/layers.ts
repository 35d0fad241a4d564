import { Group } from 'three'
import type { Point3 } from 'forage-lab'
import { type Names, piecesOf } from '../stage/layers'
import type { Palette } from '../stage/palette'
import { resultOf, type Style, styleBeside, styleOf } from '../stage/styles'
import type { FrameMessage } from '../worker/protocol'
import { colourOf } from './colours'
import { Dots } from './dots'
import { Strokes, vertices } from './strokes'

const EXACT = 'exact'
/** What is the outcome is not faded with the rest. */
const KEPT = ['best', 'smoothed', EXACT]

/** What a planner has drawn, a kind of lines and one of points for each role. */
export class Layers {
  readonly group = new Group()
  private readonly strokes = new Map<string, Strokes>()
  private readonly dots = new Map<string, Dots>()
  /** What is shown now. */
  private shown = new Set<string>()

  /** The frame's numbers are copied: it goes back to the core. */
  show(frame: FrameMessage | null, names: Names, exact: readonly Point3[], on: (role: string) => boolean): void {
    for (const each of [...this.strokes.values(), ...this.dots.values()]) each.clear()
    this.shown = new Set()
    if (frame) {
      const numbers = new Float32Array(frame.buffer, 0, frame.vertices)
      const spans = new Uint32Array(frame.buffer, frame.vertices * 4, frame.spans)
      for (const [number, role] of names.roles.entries()) {
        const pieces = piecesOf(spans, number, names.shapes)
        if (pieces.length > 0 && on(role)) this.shown.add(role)
        for (const { shape, first, count } of pieces) {
          if (shape === 'points') this.dotsOf(role).add(numbers, first, count)
          else if (shape === 'polyline' || shape === 'segments') this.strokesOf(role).add(numbers, first, count, shape === 'polyline')
        }
      }
    }
    if (exact.length > 1 && on(EXACT)) {
      this.shown.add(EXACT)
      this.strokesOf(EXACT).add(vertices(exact), 0, exact.length, true)
    }
    for (const each of [...this.strokes.values(), ...this.dots.values()]) each.done()
    for (const [role, { group }] of this.strokes) group.visible = this.shown.has(role)
    for (const [role, { points }] of this.dots) points.visible = this.shown.has(role)
  }

  /** `left`: how much of what isn't the outcome is left; `all`: of all. */
  paint(palette: Palette, left: number, all: number): void {
    const ground = colourOf(palette, '--stage')
    const result = resultOf([...this.shown])
    for (const [role, strokes] of this.strokes) {
      const style = styleBeside(role, result)
      const alpha = all * (KEPT.includes(role) ? 1 : left)
      strokes.look(style, { colour: colourOf(palette, style.colour), ground, alpha, result: KEPT.includes(role) })
    }
    for (const [role, dots] of this.dots) {
      const style = styleOf(role)
      dots.look(colourOf(palette, style.colour), style.mark, sizeOf(style), all * left * Math.max(...style.alpha))
    }
  }

  scale(each: number): void {
    for (const strokes of this.strokes.values()) strokes.scale(each)
  }

  /** A role's points, while they are shown. */
  pointsOf(role: string): Dots | null {
    return this.shown.has(role) ? (this.dots.get(role) ?? null) : null
  }

  /** Where one of a role's points is, shown or not. */
  place(role: string, index: number): Point3 | null {
    const dots = this.dots.get(role)
    if (!dots || index < 0 || index >= dots.count) return null
    const [x = 0, y = 0, z = 0] = dots.places.subarray(3 * index, 3 * index + 3)
    return [x, y, z]
  }

  private strokesOf(role: string): Strokes {
    let found = this.strokes.get(role)
    if (!found) {
      found = new Strokes(styleOf(role).order)
      this.strokes.set(role, found)
      this.group.add(found.group)
    }
    return found
  }

  private dotsOf(role: string): Dots {
    let found = this.dots.get(role)
    if (!found) {
      found = new Dots(styleOf(role).order)
      this.dots.set(role, found)
      this.group.add(found.points)
    }
    return found
  }

  drop(): void {
    for (const each of [...this.strokes.values(), ...this.dots.values()]) each.drop()
  }
}

const sizeOf = ({ point }: Style): number => point + 0.5
