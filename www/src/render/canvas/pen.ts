import { rise, type Size, type View } from '../view'
import type { Palette } from '../palette'
import { squares } from './dots'
import type { Style } from '../looks'

/** Lines and areas to be drawn. */
export type Path = Pick<Path2D, 'moveTo' | 'lineTo' | 'closePath' | 'arc' | 'rect' | 'roundRect'>

/** What is drawn on: a canvas of the page, one that a thread draws, or a file. */
export interface Context
  extends Path,
    Pick<
      OffscreenCanvasRenderingContext2D,
      | 'fillStyle'
      | 'strokeStyle'
      | 'globalAlpha'
      | 'lineWidth'
      | 'lineCap'
      | 'lineJoin'
      | 'font'
      | 'textAlign'
      | 'textBaseline'
      | 'imageSmoothingEnabled'
      | 'imageSmoothingQuality'
      | 'save'
      | 'restore'
      | 'translate'
      | 'scale'
      | 'rotate'
      | 'setLineDash'
      | 'beginPath'
      | 'fillRect'
      | 'strokeRect'
      | 'fillText'
      | 'strokeText'
    > {
  setTransform(a: number, b: number, c: number, d: number, e: number, f: number): void
  drawImage(image: CanvasImageSource, x: number, y: number, width?: number, height?: number): void
  createPattern(image: CanvasImageSource, repetition: 'repeat'): CanvasPattern | null
  stroke(path?: Path): void
  fill(path?: Path): void
  clip(path?: Path): void
  /** Only of a file: its paths are written down. */
  path?(d?: string): Path
  /** Only of a file: what follows is of this layer; null: of none. */
  layer?(role: string | null): void
}

/** What drawing needs to know. */
export interface Pen<C extends Context = Context> {
  context: C
  view: View
  size: Size
  /** Pixels of the canvas a pixel of the page. */
  density: number
  palette: Palette
}

/** On a canvas, which knows how wide its letters are. */
export type CanvasPen = Pen<Context & CanvasText & Pick<CanvasPath, 'ellipse'>>

/** Weights are drawn in steps: one stroke a step instead of one a line. */
const STEPS = 6
/** Lines that are thinner, in pixels, are hairlines. */
const HAIR = 1
/** Lines are drawn as far beyond the rim, in pixels, as the widest is wide. */
const RIM = 10
const FAINTEST_POINT = 0.65
/** Up to so many points are drawn round; more are squares, written into pixels. */
const ROUND = 3000

const stepOf = (weight: number): number => Math.min(STEPS - 1, Math.max(0, Math.floor(weight * STEPS)))

function alphaAt({ opacity: [best, worst] }: Style, step: number): number {
  return best + ((worst - best) * step) / (STEPS - 1)
}

/** A path that can be drawn on what the pen draws on. */
export const pathOf = ({ context }: { context: Context }, d?: string): Path => context.path?.(d) ?? new Path2D(d)

export function applyStyle({ context, palette }: Pen, style: Style): void {
  const colour = palette.get(style.color)
  context.strokeStyle = colour
  context.fillStyle = colour
  context.lineWidth = style.width
  // On hairlines nobody sees what round ends cost.
  context.lineJoin = style.width < HAIR ? 'bevel' : 'round'
  context.lineCap = style.width < HAIR ? 'butt' : 'round'
  context.setLineDash(style.dash ?? [])
}

/** Spans of points: x, y, z, weight a vertex. */
export function points(pen: Pen, style: Style, vertices: Float32Array, first: number, count: number): void {
  const { context, view, size } = pen
  applyStyle(pen, style)
  const { scale } = view
  const left = size.width / 2 - view.x * scale - style.point / 2
  const up = rise(view) * scale
  const top = size.height / 2 + view.y * up - style.point / 2
  const end = (first + count) * 4
  if (isMarked(style) && count < 500) {
    for (let at = first * 4; at < end; at += 4)
      marked(pen, style, left + style.point / 2 + (vertices[at] ?? 0) * scale, top + style.point / 2 - (vertices[at + 1] ?? 0) * up)
    return
  }
  // A point has less ink than a line.
  const opacities = Array.from({ length: STEPS }, (_, step) => Math.max(FAINTEST_POINT, alphaAt(style, step)))
  if (count > ROUND) {
    squares(pen, style.point, opacities, vertices.subarray(4 * first, end))
    return
  }
  for (let step = STEPS - 1; step >= 0; step -= 1) {
    context.globalAlpha = opacities[step] ?? 1
    for (let at = first * 4; at < end; at += 4) {
      if (stepOf(vertices[at + 3] ?? 0) === step)
        dot(context, left + (vertices[at] ?? 0) * scale, top - (vertices[at + 1] ?? 0) * up, style.point / 2)
    }
  }
  context.globalAlpha = 1
}

function dot(context: Context, left: number, top: number, radius: number): void {
  context.beginPath()
  context.arc(left + radius, top + radius, radius, 0, 2 * Math.PI)
  context.fill()
}

/** Points of this look are told by their form. */
export const isMarked = ({ glyph }: Style): boolean => glyph === 'ring' || glyph === 'diamond'

/** A mark that is told by its form. */
export function marked({ context }: Pen, style: Style, x: number, y: number): void {
  const half = style.point / 2
  context.beginPath()
  context.setLineDash([])
  context.lineWidth = 2
  if (style.glyph === 'diamond') {
    context.moveTo(x, y - half - 1)
    context.lineTo(x + half + 1, y)
    context.lineTo(x, y + half + 1)
    context.lineTo(x - half - 1, y)
    context.closePath()
  } else {
    context.arc(x, y, half, 0, 2 * Math.PI)
  }
  context.stroke()
}

/** Lines of one role, collected by weight and stroked together. */
export class Lines {
  private readonly paths: readonly Path[]
  private readonly used = new Uint8Array(STEPS)
  /** Where the plane lies on the screen. */
  private readonly place: { left: number; top: number; right: number; up: number }

  /** Lines that swell are told apart down to a few hundredths; what is less is left out. */
  constructor(
    private readonly pen: Pen,
    private readonly swelling = false,
  ) {
    const { view, size } = pen
    this.paths = Array.from({ length: STEPS }, () => pathOf(pen))
    const up = rise(view) * view.scale
    this.place = { left: size.width / 2 - view.x * view.scale, top: size.height / 2 + view.y * up, right: view.scale, up }
  }

  /** Leaves out what lies beyond a rim: much of a long way that is seen from near. */
  polyline(vertices: Float32Array, first: number, count: number): void {
    const path = this.pathFor(vertices[first * 4 + 3] ?? 0)
    const { left, top, right, up } = this.place
    const { width, height } = this.pen.size
    let [begun, x0, y0] = [false, 0, 0]
    for (let at = first; at < first + count; at += 1) {
      const x = left + (vertices[at * 4] ?? 0) * right
      const y = top - (vertices[at * 4 + 1] ?? 0) * up
      if (at > first) {
        const beyond = Math.max(x0, x) < -RIM || Math.min(x0, x) > width + RIM || Math.max(y0, y) < -RIM || Math.min(y0, y) > height + RIM
        if (!beyond && !begun) path.moveTo(x0, y0)
        if (!beyond) path.lineTo(x, y)
        begun = !beyond
      }
      x0 = x
      y0 = y
    }
  }

  segments(vertices: Float32Array, first: number, count: number): void {
    for (let at = first; at < first + count; at += 2) {
      const weight = vertices[at * 4 + 3] ?? 0
      const shade = this.swelling ? Math.sqrt(weight) : weight
      if (this.swelling && stepOf(shade) === 0) continue
      const path = this.pathFor(shade)
      this.vertex(path, vertices, at, true)
      this.vertex(path, vertices, at + 1, false)
    }
  }

  private pathFor(weight: number): Path {
    const step = stepOf(weight)
    this.used[step] = 1
    return this.paths[step] as Path
  }

  private vertex(path: Path, vertices: Float32Array, at: number, begins: boolean): void {
    const { left, top, right, up } = this.place
    const x = left + (vertices[at * 4] ?? 0) * right
    const y = top - (vertices[at * 4 + 1] ?? 0) * up
    if (begins) path.moveTo(x, y)
    else path.lineTo(x, y)
  }

  stroke(style: Style): void {
    const { context } = this.pen
    applyStyle(this.pen, style)
    for (let step = STEPS - 1; step >= 0; step -= 1) {
      const path = this.paths[step]
      if (!path || this.used[step] === 0) continue
      context.globalAlpha = alphaAt(style, step)
      context.lineWidth = style.width + (((style.swell ?? style.width) - style.width) * step) / (STEPS - 1)
      context.stroke(path)
    }
    context.globalAlpha = 1
  }
}
