/* Charts as files: drawn at a size of their own, with titles on their axes, a legend and a caption. */
import type { Footer } from '../display'
import { drawFooter, laidOut } from '../canvas/footer'
import { plate } from '../canvas/ground'
import { small } from '../canvas/letters'
import type { Context, Pen } from '../canvas/pen'
import { colorOf, Palette, type Theme } from '../palette'
import { PLAIN } from '../looks'
import { tick } from '../view'
import type { Stroke } from './plot'
import type { Axis } from './statistics/scale'

/** An axis with what it measures. */
export interface FigureAxis {
  title: string
  axis: Axis
}

/** Where a figure's values are drawn, in pixels of the page. */
export interface Area {
  context: Context
  palette: Palette
  left: number
  top: number
  width: number
  height: number
  /** Where a value is. */
  x(value: number): number
  y(value: number): number
}

export interface Figure {
  x: FigureAxis
  /** Null: rows, which are named where they are drawn. */
  y: FigureAxis | null
  /** Of the values, in pixels. */
  height: number
  /** Room at the right for what has no value, in pixels. */
  strip: number
  legend: Footer['legend']
  /** Draws what lies on the grid. */
  draw(area: Area): void
}

/** A line of a figure, and the band around it, if there is one. */
export interface FigureLine {
  title: string
  stroke: Stroke
  xs: readonly number[]
  ys: readonly (number | null)[]
  /** A value holds until the next. */
  stepped: boolean
  band?: { lower: readonly (number | null)[]; upper: readonly (number | null)[] } | undefined
}

/** A value that holds throughout. */
export interface FigureLevel {
  title: string
  stroke: Stroke
  value: number
}

/** In pixels of the page: as wide as a column of text. */
const WIDTH = 720
const [TOP, RIGHT, LABELS, TITLE] = [14, 20, 20, 20]
/** Room for a label next to others, and above others. */
const [ACROSS, ABOVE] = [72, 36]
const BAND = '29'
const TURN = -Math.PI / 2

interface Tick {
  place: number
  label: string
}

/** The labels of an axis of this length, in pixels, `apart` from each other. */
function ticksOf({ range: [low, high], splits, label }: Axis, length: number, apart: number): Tick[] {
  const step = tick(length / (high - low), apart)
  const first = Math.ceil(low / step - 1e-9)
  const count = Math.max(0, Math.floor(high / step + 1e-9) - first + 1)
  const places = splits?.(Math.floor(length / apart)) ?? Array.from({ length: count }, (_, at) => (first + at) * step)
  return places.filter((place) => place >= low && place <= high).map((place) => ({ place, label: label(place, step) }))
}

/** How wide a text is, in pixels. */
function widthOf(text: string): number {
  const scratch = new OffscreenCanvas(1, 1).getContext('2d')
  if (!scratch) return 7 * text.length
  scratch.font = small()
  return scratch.measureText(text).width
}

function paint(pen: Pen, { x, y, height, strip, draw }: Figure): void {
  const { context, palette, size } = pen
  const rows = y ? ticksOf(y.axis, height, ABOVE) : []
  const left = y ? TITLE + 14 + Math.max(...rows.map(({ label }) => widthOf(label)), 0) : RIGHT
  const width = size.width - left - RIGHT - strip
  const place = (axis: Axis, value: number): number => (axis.place(value) - axis.range[0]) / (axis.range[1] - axis.range[0])
  const across = (at: number): number => left + ((at - x.axis.range[0]) / (x.axis.range[1] - x.axis.range[0])) * width
  const up = (at: number): number => (y ? TOP + height * (1 - (at - y.axis.range[0]) / (y.axis.range[1] - y.axis.range[0])) : TOP)

  context.fillStyle = palette.get('--stage')
  context.fillRect(0, 0, size.width, size.height)
  context.font = small()
  context.setLineDash([])
  context.lineWidth = 1
  context.strokeStyle = palette.get('--line')
  context.beginPath()
  const columns = ticksOf(x.axis, width, ACROSS)
  for (const { place: at } of y ? rows : columns) {
    if (y) stretch(context, [left, up(at)], [left + width, up(at)])
    else stretch(context, [across(at), TOP], [across(at), TOP + height])
  }
  context.stroke()
  context.strokeStyle = palette.get('--ink-2')
  context.beginPath()
  stretch(context, [left, TOP + height], [left + width, TOP + height])
  if (y) stretch(context, [left, TOP], [left, TOP + height])
  for (const { place: at } of columns) stretch(context, [across(at), TOP + height], [across(at), TOP + height + 4])
  context.stroke()
  context.fillStyle = palette.get('--ink-2')
  context.textBaseline = 'middle'
  context.textAlign = 'right'
  for (const { place: at, label } of rows) context.fillText(label, left - 8, up(at))
  context.textAlign = 'center'
  for (const { place: at, label } of columns) context.fillText(label, across(at), TOP + height + LABELS - 6)
  context.fillStyle = palette.get('--ink')
  context.fillText(x.title, left + width / 2, TOP + height + LABELS + TITLE / 2)
  if (y) {
    context.save()
    context.translate(TITLE / 2, TOP + height / 2)
    context.rotate(TURN)
    context.fillText(y.title, 0, 0)
    context.restore()
  }
  draw({
    ...{ context, palette, left, top: TOP, width, height },
    x: (value) => left + place(x.axis, value) * width,
    y: (value) => (y ? TOP + height * (1 - place(y.axis, value)) : TOP),
  })
}

function stretch(context: Context, [x1, y1]: readonly [number, number], [x2, y2]: readonly [number, number]): void {
  context.moveTo(x1, y1)
  context.lineTo(x2, y2)
}

/** Lines, their bands and levels as a figure. */
export function lineFigure(x: FigureAxis, y: FigureAxis, lines: readonly FigureLine[], levels: readonly FigureLevel[]): Figure {
  const sample = ({ title, stroke }: FigureLine | FigureLevel): Figure['legend'][number] => ({
    title,
    look: { ...PLAIN, color: colorOf(stroke.token), width: stroke.width, ...(stroke.dash && { dash: stroke.dash }) },
    line: true,
  })
  return { ...{ x, y, height: 360, strip: 0 }, legend: [...lines, ...levels].map(sample), draw: (area) => drawLines(area, lines, levels) }
}

function drawLines(area: Area, lines: readonly FigureLine[], levels: readonly FigureLevel[]): void {
  const { context, palette, left, top, width, height } = area
  context.save()
  context.beginPath()
  context.rect(left, top - 2, width, height + 4)
  context.clip()
  context.lineJoin = 'round'
  for (const { value, stroke } of levels) {
    line(area, stroke, () => stretch(context, [left, area.y(value)], [left + width, area.y(value)]))
  }
  for (const { band, xs, stroke, stepped } of lines) {
    if (!band) continue
    // Its sides end where a value is missing.
    const known = xs.flatMap((_, at) => (Number.isFinite(band.lower[at] ?? NaN) && Number.isFinite(band.upper[at] ?? NaN) ? [at] : []))
    const side = (values: readonly (number | null)[], at: number): number => area.y(values[at] ?? 0)
    const to = (across: number): number => area.x(xs[across] ?? 0)
    context.fillStyle = palette.get(stroke.token) + BAND
    context.beginPath()
    known.forEach((at, order) => {
      if (order === 0) context.moveTo(to(at), side(band.upper, at))
      else {
        if (stepped) context.lineTo(to(at), side(band.upper, known[order - 1] ?? at))
        context.lineTo(to(at), side(band.upper, at))
      }
    })
    known.toReversed().forEach((at, order, all) => {
      if (stepped && order > 0) context.lineTo(to(all[order - 1] ?? at), side(band.lower, at))
      context.lineTo(to(at), side(band.lower, at))
    })
    context.closePath()
    context.fill()
  }
  for (const { stroke, xs, ys, stepped } of lines) line(area, stroke, () => trace(area, xs, ys, stepped))
  context.setLineDash([])
  context.restore()
}

function line({ context, palette }: Area, { token, width, dash }: Stroke, along: () => void): void {
  context.strokeStyle = palette.get(token)
  context.lineWidth = width
  context.setLineDash(dash ?? [])
  context.beginPath()
  along()
  context.stroke()
}

/** Gaps part it; a lone value is a short stretch. */
function trace({ context, x, y }: Area, xs: readonly number[], ys: readonly (number | null)[], stepped: boolean): void {
  let before: number | null = null
  xs.forEach((across, at) => {
    const value = ys[at] ?? null
    const height = value === null ? NaN : y(value)
    if (!Number.isFinite(height)) {
      before = null
      return
    }
    if (before === null) {
      context.moveTo(x(across), height)
      if ((ys[at + 1] ?? null) === null) context.lineTo(x(across) + 2, height)
    } else {
      if (stepped) context.lineTo(x(across), before)
      context.lineTo(x(across), height)
    }
    before = height
  })
}

/** A name on a ground of its own. */
export function named({ context, palette }: Area, text: string, x: number, y: number): void {
  context.font = small()
  context.fillStyle = palette.get('--ink')
  context.textAlign = 'left'
  context.textBaseline = 'middle'
  plate(context, palette.get('--stage'), text, x, y)
}

function prepared(
  figure: Figure,
  footer: Footer | undefined,
): { height: number; size: { width: number; height: number }; draw(pen: Pen): void } {
  const height = TOP + figure.height + LABELS + TITLE + 6
  const sheet = footer && laidOut({ ...footer, legend: figure.legend }, WIDTH)
  const size = { width: WIDTH, height }
  return {
    size,
    height: height + (sheet?.height ?? 0),
    draw(pen) {
      paint(pen, figure)
      if (sheet) drawFooter(pen, sheet, height)
    },
  }
}

const penOn = (context: Context, theme: Theme, size: Pen['size'], density: number): Pen => ({
  ...{ context, size, density, palette: new Palette(theme) },
  view: { x: 0, y: 0, scale: 1 },
})

/** A figure as SVG with this title. */
export async function svgOf(figure: Figure, title: string, footer: Footer | undefined, theme: Theme): Promise<string> {
  const { VectorContext } = await import('../vector/context')
  const { height, size, draw } = prepared(figure, footer)
  const context = new VectorContext(WIDTH, height, 1)
  draw(penOn(context, theme, size, 1))
  return context.svg(title)
}

/** A figure as PNG, with so many pixels a pixel of the page. */
export async function pngOf(figure: Figure, footer: Footer | undefined, theme: Theme, density: number): Promise<Blob> {
  const { height, size, draw } = prepared(figure, footer)
  const sheet = new OffscreenCanvas(WIDTH * density, Math.round(height * density))
  const context = sheet.getContext('2d')
  if (!context) throw new Error('this browser gives no canvas')
  context.setTransform(density, 0, 0, density, 0, 0)
  draw(penOn(context as Context, theme, size, density))
  return sheet.convertToBlob()
}
