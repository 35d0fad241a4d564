import type { Looks, Renderer } from '../../render/display'
import type { Lab } from '../../stores/lab.svelte'
import { canvasesOf } from '../stage/canvases'

/** What is seen, as a PNG with so many pixels a pixel of the page. */
export async function pictureOf(lab: Lab, renderer: Renderer, density: number, looks?: Looks): Promise<Blob> {
  const { over } = canvasesOf(lab)
  const picture = await renderer.files.picture(density, looks)
  if (!over) return picture
  const beneath = await createImageBitmap(picture)
  const whole = new OffscreenCanvas(beneath.width, beneath.height)
  const context = whole.getContext('2d')
  context?.drawImage(beneath, 0, 0)
  // Beneath the stage there may be a caption.
  const { width, height } = over.size()
  context?.rect(0, 0, width * density, height * density)
  context?.clip()
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
  return `${drawing.slice(0, end)}<svg width="${width}" height="${height}">${await context.content()}</svg>\n${drawing.slice(end)}`
}
