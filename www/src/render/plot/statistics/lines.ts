import uPlot from 'uplot'
import { axis, faint, type Theme } from './base'
import { DASHES } from './strokes'
import type { Axis } from './scale'

/** A line over evaluations, and the band about it, if there is one. */
export interface Line {
  slot: number
  label: string
  values: (number | null)[]
  band?: { lower: (number | null)[]; upper: (number | null)[] }
}

export interface LineOptions {
  evaluations: number[]
  lines: readonly Line[]
  theme: Theme
  x: Axis
  y: Axis
  /** Values that hold throughout. */
  levels: readonly number[]
  onhover(at: number | null): void
}

const BAND = 0.16

/** Steps: a value holds until the next. */
export function linePlot(host: HTMLElement, { evaluations, lines, theme, x, y, levels, onhover }: LineOptions): uPlot {
  const stepped = uPlot.paths.stepped?.({ align: 1 })
  const places = (values: readonly (number | null)[]): (number | null)[] => values.map((value) => (value === null ? null : y.place(value)))
  const series: uPlot.Series[] = [{}]
  const data: (number | null)[][] = []
  const bands: uPlot.Band[] = []
  const add = (values: readonly (number | null)[], stroke: Pick<uPlot.Series, 'stroke' | 'width' | 'dash'>): void => {
    data.push(places(values))
    series.push({ ...stroke, ...(stepped && { paths: stepped }), spanGaps: false, points: { show: false } })
  }
  lines.forEach(({ band }, at) => {
    if (!band) return
    const none = { stroke: 'transparent', width: 0 }
    add(band.upper, none)
    add(band.lower, none)
    bands.push({ series: [series.length - 2, series.length - 1], fill: faint(theme.series[at] ?? theme.ink, BAND) })
  })
  lines.forEach(({ slot, values }, at) => {
    const dash = DASHES[slot]
    add(values, { stroke: theme.series[at] ?? theme.ink, width: 2.25, ...(dash && { dash }) })
  })
  return new uPlot(
    {
      width: host.clientWidth,
      height: host.clientHeight,
      padding: [10, 16, 0, 0],
      legend: { show: false },
      cursor: { y: false, drag: { x: false, y: false }, points: { show: false } },
      scales: { x: { time: false, range: () => x.range }, y: { range: () => y.range } },
      axes: [
        axis({ theme, side: 'x', splits: x.splits, label: x.label, grid: false }),
        axis({ theme, side: 'y', splits: y.splits, label: y.label, grid: true }),
      ],
      series,
      bands,
      hooks: {
        drawAxes: [
          (plot) => {
            for (const level of levels) levelled(plot, y.place(level), theme.exact)
          },
        ],
        setCursor: [(plot) => onhover(plot.cursor.idx ?? null)],
      },
    },
    [evaluations.map(x.place), ...data] as uPlot.AlignedData,
    host,
  )
}

function levelled({ ctx, bbox, valToPos }: uPlot, level: number, colour: string): void {
  const at = valToPos(level, 'y', true)
  if (at < bbox.top || at > bbox.top + bbox.height) return
  ctx.save()
  ctx.beginPath()
  ctx.strokeStyle = colour
  ctx.lineWidth = 1.5 * devicePixelRatio
  ctx.setLineDash([5 * devicePixelRatio, 4 * devicePixelRatio])
  ctx.moveTo(bbox.left, at)
  ctx.lineTo(bbox.left + bbox.width, at)
  ctx.stroke()
  ctx.restore()
}
