import { perLab } from '../../stores/context.svelte'
import type { Display, Footer, Looks, Renderer } from '../../render/display'
import type { Lab } from '../../stores/lab.svelte'

/** The canvases of a stage, lowest first, for those who want to save what they show. */
interface Canvases {
  canvas: HTMLCanvasElement | null
  over: HTMLCanvasElement | null
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
  // Below what it lies over there may be more.
  context?.drawImage(over, 0, 0, beneath.width, (over.height * beneath.width) / over.width)
  beneath.close()
  return whole.convertToBlob()
}
