import type { FieldPicture } from '../frame'
import type { Pen } from './pen'
import { toScreen } from '../view'

/** Draws a field's values, a crisp square each. */
export function drawRaster({ context, view, size }: Pen, { bitmap, min, max }: FieldPicture, alpha: number): void {
  // The first row lies at the smallest y, wherever that is on the screen.
  const [left, first] = toScreen(view, size, min)
  const [right, last] = toScreen(view, size, max)
  context.save()
  context.imageSmoothingEnabled = false
  context.globalAlpha = alpha
  context.translate(left, first)
  context.scale((right - left) / bitmap.width, (last - first) / bitmap.height)
  context.drawImage(bitmap, 0, 0)
  context.restore()
}
