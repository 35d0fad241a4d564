import type { Session } from 'forage-lab'
import type { FieldPicture } from './protocol'

let canvas: OffscreenCanvas | undefined

/** The fields of these roles in the frame that was drawn last, as pictures. */
export function fieldsOf(session: Session, roles: readonly string[], dark: boolean): FieldPicture[] {
  return roles.flatMap((role) => {
    const layer = session.layerImage(role, dark)
    if (!layer) return []
    const { image, min, max, range } = layer
    canvas ??= new OffscreenCanvas(image.width, image.height)
    Object.assign(canvas, { width: image.width, height: image.height })
    canvas.getContext('2d')?.putImageData(image, 0, 0)
    return [{ role, bitmap: canvas.transferToImageBitmap(), min, max, range }]
  })
}
