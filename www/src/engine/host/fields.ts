import type { LayerImage, LayerName, Ramp, Session } from 'forage-lab'
import type { FieldPicture, Viewport } from '../../render/frame'

let canvas: OffscreenCanvas | undefined

/** These fields of the frame that was drawn last, as pictures. */
export function fieldsOf(session: Session, fields: Viewport['fields']): FieldPicture[] {
  return fields.flatMap(({ role, ramp }) => {
    const layer = layerOf(session, role, ramp)
    if (!layer) return []
    const { image, min, max, range } = layer
    canvas ??= new OffscreenCanvas(image.width, image.height)
    Object.assign(canvas, { width: image.width, height: image.height })
    canvas.getContext('2d')?.putImageData(image, 0, 0)
    return [{ role, bitmap: canvas.transferToImageBitmap(), min, max, range }]
  })
}

/** A layer of a planner whose part of the core is not here is not in this frame either. */
function layerOf(session: Session, role: string, ramp: Ramp): LayerImage | null {
  try {
    return session.layerImage(role as LayerName, ramp)
  } catch (error) {
    if (error instanceof Error && 'code' in error && error.code === 'unknown') return null
    throw error
  }
}
