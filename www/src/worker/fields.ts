import type { LayerImage, LayerName, Session } from 'forage-lab'
import type { FieldPicture } from './protocol'

let canvas: OffscreenCanvas | undefined

/** The fields of these roles in the frame that was drawn last, as pictures. */
export function fieldsOf(session: Session, roles: readonly string[], dark: boolean): FieldPicture[] {
  return roles.flatMap((role) => {
    const layer = layerOf(session, role, dark)
    if (!layer) return []
    const { image, min, max, range } = layer
    canvas ??= new OffscreenCanvas(image.width, image.height)
    Object.assign(canvas, { width: image.width, height: image.height })
    canvas.getContext('2d')?.putImageData(image, 0, 0)
    return [{ role, bitmap: canvas.transferToImageBitmap(), min, max, range }]
  })
}

/** A layer of a planner whose part of the core is not here is not in this frame either. */
function layerOf(session: Session, role: string, dark: boolean): LayerImage | null {
  try {
    return session.layerImage(role as LayerName, dark)
  } catch (error) {
    if (error instanceof Error && 'code' in error && error.code === 'unknown') return null
    throw error
  }
}
