import { perLab } from '../../stores/context.svelte'
import type { Display, Footer, Renderer } from '../../render/display'
import type { Context } from '../../render/canvas/pen'
import type { Theme } from '../../render/palette'
import type { Size } from '../../render/view'

/** The canvases of a stage, lowest first, for those who want to save what they show. */
interface Canvases {
  canvas: HTMLCanvasElement | null
  /** What lies over it. */
  over: { size(): Size; drawOn(context: Context, density: number, theme: Theme): void } | null
  /** Who draws the lowest. */
  renderer: Renderer | null
  /** What is seen. */
  display: Display | null
  /** What its legend says is shown. */
  legend: Footer['legend']
}

export const canvasesOf = perLab((): Canvases => ({ canvas: null, over: null, renderer: null, display: null, legend: [] }))
