import uPlot from 'uplot'
import 'uplot/dist/uPlot.min.css'
import { number } from '../../text/number'
import { decades, type Range, type Scale } from './scale'

export interface Stroke {
  /** A custom property's name. */
  token: string
  width: number
  dash?: number[]
}

export interface PlotOptions {
  strokes: Stroke[]
  scale: Scale
  /** Asked whenever the data changed. */
  range(): Range
  last(): number
  /** Room for the labels on the left, in pixels; absent: as much as they need. */
  gutter?: number
  /** Values that are allowed: shown as a band. Asked whenever it is drawn. */
  band?(): readonly [number, number] | undefined
  onhover(point: number | null): void
  /** The scales hold only once it is drawn. */
  ondrawn(): void
}

const DECADES = 6
const NARROW = 44

/** A chart in `host`, coloured by the tokens that hold there. */
export function createPlot(host: HTMLElement, { strokes, scale, range, last, gutter, band, onhover, ondrawn }: PlotOptions): uPlot {
  const [ink, line, allowed, edge, ...colours] = resolve(host, [
    '--ink-2',
    '--line',
    '--accent-soft',
    '--danger',
    ...strokes.map(({ token }) => token),
  ])
  const font = `11px ${getComputedStyle(host).fontFamily}`
  const axis: uPlot.Axis = {
    stroke: ink ?? 'gray',
    font,
    grid: { stroke: line ?? 'gray', width: 1 },
    ticks: { show: false },
  }
  const log = scale === 'log'
  const options: uPlot.Options = {
    width: Math.max(host.clientWidth, NARROW),
    height: Math.max(host.clientHeight, NARROW),
    padding: [8, 14, 0, 0],
    legend: { show: false },
    cursor: { y: false, drag: { x: false, y: false }, points: { size: 6 } },
    scales: {
      x: { time: false, range: () => [0, Math.max(1, last())] },
      y: { distr: log ? 3 : 1, range },
    },
    axes: [
      { ...axis, size: 26, grid: { show: false }, values: (_, splits) => splits.map((k) => (Number.isInteger(k) ? number(k) : '')) },
      {
        ...axis,
        size: (_, labels) => gutter ?? 10 + 6.4 * Math.max(2, ...(labels ?? []).map((label) => label.length)),
        ...(log
          ? {
              splits: (_: uPlot, __: number, min: number, max: number) => decades([min, max], DECADES),
              filter: (_: uPlot, splits: number[]) => splits,
              values: (_: uPlot, splits: number[]) => splits.map((value) => power(value)),
            }
          : {
              ...(band?.() && { splits: () => limitsOf(band()) }),
              values: (_: uPlot, splits: number[], __: number, ___: number, step: number) =>
                splits.map((value) => label(value, band?.() ? 1 : step)),
            }),
      },
    ],
    series: [
      {},
      ...strokes.map(
        ({ width, dash }, at): uPlot.Series => ({
          stroke: colours[at] ?? 'gray',
          width,
          ...(dash && { dash }),
          spanGaps: false,
          // A lone first iteration has no line yet.
          points: { show: (u) => u.data[0].length < 2, size: 5 },
        }),
      ),
    ],
    hooks: {
      drawClear: [(u) => banded(u, band?.(), allowed ?? 'gray', edge ?? 'gray')],
      setCursor: [(u) => onhover(u.cursor.idx ?? null)],
      draw: [ondrawn],
    },
  }
  return new uPlot(options, [[]], host)
}

/** The labels beside a band: its limits, and zero within. */
const limitsOf = ([low, high]: readonly [number, number] = [0, 0]): number[] => (low < 0 && high > 0 ? [low, 0, high] : [low, high])

/** What is allowed, between its limits. */
function banded({ ctx, bbox, valToPos }: uPlot, band: readonly [number, number] | undefined, colour: string, edge: string): void {
  if (!band) return
  const [low, high] = [valToPos(band[0], 'y', true), valToPos(band[1], 'y', true)]
  ctx.save()
  ctx.beginPath()
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height)
  ctx.clip()
  ctx.fillStyle = colour
  ctx.fillRect(bbox.left, high, bbox.width, low - high)
  ctx.strokeStyle = edge
  ctx.lineWidth = devicePixelRatio
  ctx.setLineDash([4 * devicePixelRatio, 3 * devicePixelRatio])
  ctx.beginPath()
  for (const y of [low, high]) {
    ctx.moveTo(bbox.left, y)
    ctx.lineTo(bbox.left + bbox.width, y)
  }
  ctx.stroke()
  ctx.restore()
}

function power(value: number): string {
  const exponent = Math.round(Math.log10(value))
  return exponent >= -2 && exponent <= 4 ? String(value) : number(value, 1).replace(/^1×/, '')
}

/** As many decimals as the distance of the labels needs. */
function label(value: number, step: number): string {
  let decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9))
  // Steps of 0.025 need a digit more than those of 0.02.
  if (Math.abs(step * 10 ** decimals - Math.round(step * 10 ** decimals)) > 1e-6) decimals += 1
  const size = Math.abs(value)
  if (decimals > 6 || size >= 1e6) return number(value, 3)
  return `${value < 0 ? '−' : ''}${size.toFixed(decimals)}`
}

/** What colours the custom properties come to, whatever functions they are written with. */
function resolve(host: HTMLElement, tokens: string[]): string[] {
  const probe = host.appendChild(document.createElement('span'))
  const colours = tokens.map((token) => {
    probe.style.color = `var(${token})`
    return getComputedStyle(probe).color
  })
  probe.remove()
  return colours
}
