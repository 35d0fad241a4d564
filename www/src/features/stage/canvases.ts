import { perLab } from '../../stores/context.svelte'
import type { Renderer } from '../../render/display'
import type { Lab } from '../../stores/lab.svelte'

/** The canvases of a stage, lowest first, for those who want to save what they show. */
interface Canvases {
  canvas: HTMLCanvasElement | null
  over: HTMLCanvasElement | null
  draw?: (() => void) | undefined
  /** Who draws the lowest, where it is one of the plane. */
  renderer: Renderer | null
}

export const canvasesOf = perLab((): Canvases => ({ canvas: null, over: null, renderer: null }))

/** What is seen, as one picture. */
export function seen(lab: Lab): HTMLCanvasElement | null {
  const { canvas, over, draw } = canvasesOf(lab)
  // Some keep what they have drawn only until the next moment.
  draw?.()
  if (!canvas || !over) return canvas
  const whole = document.createElement('canvas')
  Object.assign(whole, { width: canvas.width, height: canvas.height })
  const context = whole.getContext('2d')
  context?.drawImage(canvas, 0, 0)
  context?.drawImage(over, 0, 0, canvas.width, canvas.height)
  return whole
}
