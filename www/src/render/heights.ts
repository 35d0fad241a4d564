import type { Ramp, Scene } from 'forage-lab'
import type { Ground } from './display'
import type { FieldRequest, HeightMap } from './frame'
import { type Box, type Size, toScene, type View } from './view'

type Paint = (request: FieldRequest) => Promise<HeightMap | null>

/** How fine the heights are sampled, in pixels of the canvas a side. */
const FINEST = 700

/** Asks for the heat map of a function whenever the view has changed; the one that is shown is moved and stretched until the next is there. */
export class Heights {
  private asked = ''
  private busy = false
  private shown = false

  constructor(
    private readonly paint: Paint,
    private readonly show: (ground: Ground | null, heights?: readonly number[]) => void,
    /** There is an answer: something else may be wanted meanwhile. */
    private readonly answered: () => void,
  ) {}

  /** Asks for a picture of this view, unless there is one. */
  want(scene: Scene, view: View, size: Size, generation: number, ramp: Ramp): void {
    if (scene.kind !== 'function') {
      this.drop()
      return
    }
    const what = 'expression' in scene ? [scene.expression, JSON.stringify(scene.bounds)] : [scene.function]
    const key = [generation, ...what, scene.dimension, view.x, view.y, view.scale, size.width, size.height, ramp].join()
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
    const [width, height] = [size.width, size.height].map((side) => Math.max(1, Math.round(side * fine))) as [number, number]
    try {
      const map = await this.paint({ scene, ...box, width, height, ramp })
      // Nobody may want it any more.
      if (this.asked === '') map?.bitmap.close()
      else {
        this.shown = map !== null
        this.show(map && { bitmap: map.bitmap, box }, map?.heights)
      }
      this.busy = false
      this.answered()
    } catch {
      // The thread broke down: the next one is asked.
      this.asked = ''
      this.busy = false
    }
  }

  drop(): void {
    this.asked = ''
    if (this.shown) this.show(null)
    this.shown = false
  }
}
