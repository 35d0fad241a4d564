import { perLab } from '../../stores/context.svelte'
import type { Renderer } from '../../render/display'
import type { Lab } from '../../stores/lab.svelte'

/** The canvases of a stage, lowest first, for those who want to save what they show. */
interface Canvases {
  canvas: HTMLCanvasElement | null
  over: HTMLCanvasElement | null
  /** Who draws the lowest. */
  renderer: Renderer | null
}

export const canvasesOf = perLab((): Canvases => ({ canvas: null, over: null, renderer: null }))

/** What is seen, as a PNG. */
export async function pictureOf(lab: Lab): Promise<Blob | null> {
  const { renderer, over } = canvasesOf(lab)
  const picture = (await renderer?.picture(devicePixelRatio || 1)) ?? null
  if (!picture || !over) return picture
  const beneath = await createImageBitmap(picture)
  const whole = new OffscreenCanvas(beneath.width, beneath.height)
  const context = whole.getContext('2d')
  context?.drawImage(beneath, 0, 0)
  context?.drawImage(over, 0, 0, beneath.width, beneath.height)
  beneath.close()
  return whole.convertToBlob()
}
