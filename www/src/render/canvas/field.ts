import type { Ramp, Scene } from 'forage-lab'
import type { FieldRequest } from '../frame'
import type { Pen } from './pen'
import { type Box, type Size, toScene, toScreen, type View } from '../view'

type Paint = (request: FieldRequest) => Promise<ImageBitmap | null>

/** How fine the heights are sampled, in pixels of the canvas a side. */
const FINEST = 700

/** The heat map behind a function: painted by the worker for a view, shown moved and stretched until the next is there. */
export class Field {
  private picture: { bitmap: ImageBitmap; box: Box; key: string } | null = null
  private asked = ''
  private busy = false

  constructor(
    private readonly paint: Paint,
    private readonly changed: () => void,
  ) {}

  draw({ context, view, size }: Pen): void {
    if (!this.picture) return
    const { bitmap, box } = this.picture
    const [left, bottom] = toScreen(view, size, box.min)
    const [right, top] = toScreen(view, size, box.max)
    context.imageSmoothingQuality = 'high'
    context.drawImage(bitmap, left, top, right - left, bottom - top)
  }

  /** Asks for a picture of this view, unless there is one. */
  want(scene: Scene, view: View, size: Size, generation: number, ramp: Ramp): void {
    if (scene.kind !== 'function') {
      this.drop()
      return
    }
    const key = [generation, scene.function, scene.dimension, view.x, view.y, view.scale, size.width, size.height, ramp].join()
    if (key === this.asked || this.busy) return
    void this.ask(key, scene, view, size, ramp)
  }

  private async ask(key: string, scene: Scene, view: View, size: Size, ramp: Ramp): Promise<void> {
    this.asked = key
    this.busy = true
    const [left, top] = toScene(view, size, [0, 0])
    const [right, bottom] = toScene(view, size, [size.width, size.height])
    const box: Box = { min: [left, bottom], max: [right, top] }
    const fine = Math.min(1, FINEST / Math.max(size.width, size.height))
    const bitmap = await this.paint({
      scene,
      ...box,
      width: Math.max(1, Math.round(size.width * fine)),
      height: Math.max(1, Math.round(size.height * fine)),
      ramp,
    })
    this.busy = false
    this.picture?.bitmap.close()
    this.picture = bitmap ? { bitmap, box, key } : null
    this.changed()
  }

  /** The one that was asked will never answer. */
  forget(): void {
    this.asked = ''
    this.busy = false
  }

  drop(): void {
    this.asked = ''
    this.picture?.bitmap.close()
    this.picture = null
  }
}
