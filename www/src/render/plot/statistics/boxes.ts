import uPlot from 'uplot'
import type { GroupSummary } from 'forage-lab'
import { axis, type Colours, faint, type Theme } from './base'
import { GOLDEN, jitter, PADDING, PLASTIC, ROW } from './layout'
import type { Axis } from './scale'

/** A run that is drawn as a dot. */
export interface PlottedRun {
  record: { seed: number }
  /** Farther from the quartiles than 1.5 times their distance. */
  outlier: boolean
}

/** A row of the plot. */
export interface PlottedGroup<R extends PlottedRun> {
  summary: GroupSummary
  runs: readonly R[]
}

/** A run's dot, in pixels of the page from the plot's corner. */
export interface Dot<R extends PlottedRun> {
  x: number
  y: number
  run: R
}

export interface BoxOptions<R extends PlottedRun, G extends PlottedGroup<R>> {
  groups: readonly G[]
  theme: Theme
  axis: Axis
  /** What a run comes to; null without a feasible result. */
  valueOfRun(run: R): number | null
  /** What is drawn of a group's summary, in the same measure. */
  quartilesOf(group: G): Quartiles | null
  exactOf(group: G): number | null
  ondrawn(dots: Dot<R>[]): void
}

export interface Quartiles {
  low: number
  lower: number
  median: number
  upper: number
  high: number
}

const DOT = 2.75

/** Room at the right, for runs without a result. */
export const stripOf = (groups: readonly PlottedGroup<PlottedRun>[]): number =>
  groups.some(({ summary }) => !isFeasible(summary)) ? PADDING.strip : PADDING.side

export const isFeasible = ({ feasible, runs }: GroupSummary): boolean => feasible === runs

export function boxPlot<R extends PlottedRun, G extends PlottedGroup<R>>(host: HTMLElement, options: BoxOptions<R, G>): uPlot {
  const { groups, theme, axis: scale } = options
  const strip = stripOf(groups)
  return new uPlot(
    {
      width: host.clientWidth,
      height: host.clientHeight,
      padding: [PADDING.top, strip, 0, PADDING.side],
      legend: { show: false },
      cursor: { show: false },
      scales: { x: { time: false, range: () => scale.range }, y: { range: () => [0, Math.max(1, groups.length)] } },
      axes: [axis({ theme, side: 'x', splits: scale.splits, label: scale.label, grid: true }), { show: false }],
      series: [{}, { show: true, stroke: 'transparent', points: { show: false } }],
      hooks: {
        draw: [
          (plot) => {
            const { ctx, bbox } = plot
            const place = (value: number): number => plot.valToPos(scale.place(value), 'x', true)
            const ground = { ctx, place, top: bbox.top, end: bbox.left + bbox.width, strip, ratio: devicePixelRatio }
            options.ondrawn(groups.flatMap((group, at) => drawRow(ground, group, at, options)))
          },
        ],
      },
    },
    [scale.range, [null, null]],
    host,
  )
}

/** What rows are drawn on, in pixels of `ctx`: a canvas of the page, or a file. */
export interface Ground {
  ctx: Brush
  top: number
  /** Where the values end at the right. */
  end: number
  /** Room beyond it for runs without a result. */
  strip: number
  /** Pixels of `ctx` a pixel of the page. */
  ratio: number
  /** Where a value of the runs is. */
  place(value: number): number
}

type Brush = Pick<
  CanvasRenderingContext2D,
  'save' | 'restore' | 'beginPath' | 'setLineDash' | 'strokeStyle' | 'lineWidth' | 'fillStyle' | 'moveTo' | 'lineTo' | 'rect' | 'arc'
> & { stroke(): void; fill(): void }

/** What tells how rows look. */
export interface RowOptions<R extends PlottedRun, G extends PlottedGroup<R>>
  extends Pick<BoxOptions<R, G>, 'valueOfRun' | 'quartilesOf' | 'exactOf'> {
  theme: Colours
}

/** A row: the box above its dots, and those without a result beside them. */
export function drawRow<R extends PlottedRun, G extends PlottedGroup<R>>(
  { ctx, top: first, end, strip, ratio, place }: Ground,
  group: G,
  at: number,
  options: RowOptions<R, G>,
): Dot<R>[] {
  const { theme, valueOfRun } = options
  const top = first + at * ROW.height * ratio
  const colour = theme.series[at] ?? theme.ink
  ctx.save()

  if (at > 0) line(ctx, 0, top, end + strip * ratio, top, theme.line, ratio)
  const exact = options.exactOf(group)
  if (exact !== null) line(ctx, place(exact), top, place(exact), top + ROW.height * ratio, theme.exact, 1.5 * ratio, [5 * ratio, 4 * ratio])

  const quartiles = options.quartilesOf(group)
  if (quartiles) box(ctx, quartiles, place, top, colour, ratio)

  const dots = group.runs.map((run): Dot<R> => {
    const value = valueOfRun(run)
    const y = top + (ROW.dots + ROW.dotsHeight * jitter(run.record.seed + 1, GOLDEN)) * ratio
    if (value !== null) return { x: place(value), y, run }
    const from = end + 14 * ratio
    return { x: from + (strip - 28) * ratio * jitter(run.record.seed + 1, PLASTIC), y, run }
  })
  for (const { x, y, run } of dots) mark(ctx, x, y, run, valueOfRun(run) === null, colour, theme, ratio)
  ctx.restore()
  return dots.map(({ x, y, run }) => ({ x: x / ratio, y: y / ratio, run }))
}

function line(ctx: Brush, x1: number, y1: number, x2: number, y2: number, colour: string, width: number, dash: number[] = []): void {
  ctx.beginPath()
  ctx.setLineDash(dash)
  ctx.strokeStyle = colour
  ctx.lineWidth = width
  ctx.moveTo(x1, y1)
  ctx.lineTo(x2, y2)
  ctx.stroke()
  ctx.setLineDash([])
}

function box(
  ctx: Brush,
  { low, lower, median, upper, high }: Quartiles,
  place: (value: number) => number,
  top: number,
  colour: string,
  ratio: number,
): void {
  const [from, height] = [top + ROW.box * ratio, ROW.boxHeight * ratio]
  const middle = from + height / 2
  const [left, right] = [place(lower), place(upper)]
  for (const [a, b] of [
    [place(low), left],
    [right, place(high)],
  ] as const)
    line(ctx, a, middle, b, middle, colour, 1.25 * ratio)
  for (const end of [place(low), place(high)]) line(ctx, end, middle - height / 4, end, middle + height / 4, colour, 1.25 * ratio)
  ctx.fillStyle = faint(colour, 0.22)
  ctx.strokeStyle = colour
  ctx.lineWidth = 1.25 * ratio
  ctx.beginPath()
  ctx.rect(left, from, right - left, height)
  ctx.fill()
  ctx.stroke()
  line(ctx, place(median), from, place(median), from + height, colour, 3 * ratio)
}

/** A dot; an outlier's is a ring, one without a result a cross. */
function mark(ctx: Brush, x: number, y: number, run: PlottedRun, none: boolean, colour: string, theme: Colours, ratio: number): void {
  const size = DOT * ratio
  ctx.beginPath()
  if (none) {
    line(ctx, x - size, y - size, x + size, y + size, theme.danger, 1.5 * ratio)
    line(ctx, x - size, y + size, x + size, y - size, theme.danger, 1.5 * ratio)
    return
  }
  ctx.arc(x, y, run.outlier ? size * 1.5 : size, 0, 2 * Math.PI)
  ctx.fillStyle = run.outlier ? theme.surface : faint(colour, 0.62)
  ctx.fill()
  if (!run.outlier) return
  ctx.strokeStyle = colour
  ctx.lineWidth = 2 * ratio
  ctx.stroke()
}
