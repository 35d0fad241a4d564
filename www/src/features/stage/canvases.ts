import { perLab } from '../../stores/context.svelte'
import type { Display, Footer, Looks, Renderer } from '../../render/display'
import type { Context } from '../../render/canvas/pen'
import type { Theme } from '../../render/palette'
import type { Size } from '../../render/view'
import type { Lab } from '../../stores/lab.svelte'

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

/** What is seen, as a PNG with so many pixels a pixel of the page. */
export async function pictureOf(lab: Lab, renderer: Renderer, density: number, looks?: Looks): Promise<Blob> {
  const { over } = canvasesOf(lab)
  const picture = await renderer.files.picture(density, looks)
  if (!over) return picture
  const beneath = await createImageBitmap(picture)
  const whole = new OffscreenCanvas(beneath.width, beneath.height)
  const context = whole.getContext('2d')
  context?.drawImage(beneath, 0, 0)
  if (context) over.drawOn(context, density, looks?.theme ?? { dark: lab.theme.dark })
  beneath.close()
  return whole.convertToBlob()
}

/** The same as SVG. */
export async function drawingOf(lab: Lab, renderer: Renderer, title: string, looks?: Looks): Promise<string> {
  const { over } = canvasesOf(lab)
  const drawing = await renderer.files.svg(title, looks)
  if (!over) return drawing
  const { VectorContext } = await import('../../render/vector/context')
  const { width, height } = over.size()
  const context = new VectorContext(width, height, 1)
  context.layer('drive')
  over.drawOn(context, 1, looks?.theme ?? { dark: lab.theme.dark })
  const end = drawing.lastIndexOf('</svg>')
  return `${drawing.slice(0, end)}${await context.content()}\n${drawing.slice(end)}`
}
