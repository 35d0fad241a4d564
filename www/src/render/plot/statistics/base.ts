import type uPlot from 'uplot'
import 'uplot/dist/uPlot.min.css'
import type { Axis } from './scale'

/** The colours of a chart. */
export interface Colours {
  ink: string
  line: string
  exact: string
  danger: string
  surface: string
  /** Of the entrants, by their places. */
  series: string[]
}

export interface Theme extends Colours {
  font: string
}

/** What the tokens come to here, as a canvas understands it. */
export function themeOf(host: HTMLElement, slots: readonly number[]): Theme {
  const probe = host.appendChild(document.createElement('span'))
  const colour = (token: string): string => {
    probe.style.color = `var(${token})`
    return getComputedStyle(probe).color
  }
  const [ink = '', line = '', exact = '', danger = '', surface = ''] = ['--ink-2', '--line', '--exact', '--danger', '--surface'].map(colour)
  const series = slots.map((slot) => colour(`--series-${slot + 1}`))
  probe.remove()
  return { ink, line, exact, danger, surface, series, font: `11px ${getComputedStyle(host).fontFamily}` }
}

/** The same colour, seen through. */
export function faint(colour: string, share: number): string {
  if (colour.startsWith('#')) return `${colour.slice(0, 7)}${hex(Math.round(255 * share))}`
  const parts = colour.match(/[\d.]+/g)?.slice(0, 3)
  return parts ? `rgb(${parts.join(' ')} / ${share})` : colour
}

const hex = (value: number): string => value.toString(16).padStart(2, '0')

interface AxisOptions {
  theme: Theme
  side: 'x' | 'y'
  splits: Axis['splits'] | undefined
  label(place: number, step: number): string
  grid: boolean
}

const LETTER = 6.4
/** Room for a label beside others, and above others, in pixels. */
const [ACROSS, ABOVE] = [64, 24]

export function axis({ theme, side, splits, label, grid }: AxisOptions): uPlot.Axis {
  return {
    stroke: theme.ink,
    font: theme.font,
    grid: { show: grid, stroke: theme.line, width: 1 },
    ticks: { show: false },
    ...(splits && {
      splits: (plot: uPlot) => splits(Math.floor(side === 'x' ? plot.width / ACROSS : plot.height / ABOVE)),
      filter: (_: uPlot, places: number[]) => places,
    }),
    values: (_, places, __, ___, step) => places.map((place) => label(place, step)),
    ...(side === 'x'
      ? { size: 28, space: 64 }
      : { size: (_: uPlot, labels: string[]) => 12 + LETTER * Math.max(2, ...(labels ?? []).map(({ length }) => length)) }),
  }
}

/** Makes a plot now, and again whenever its host's size changes. */
export function drawn(host: HTMLElement, make: (host: HTMLElement) => uPlot): () => void {
  let plot: uPlot | undefined
  // A frame later the theme's tokens hold.
  const frame = requestAnimationFrame(() => {
    plot = make(host)
  })
  const observer = new ResizeObserver(() => plot?.setSize({ width: host.clientWidth, height: host.clientHeight }))
  observer.observe(host)
  return () => {
    cancelAnimationFrame(frame)
    observer.disconnect()
    plot?.destroy()
  }
}
