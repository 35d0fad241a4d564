import type { Picture } from '../engine/protocol'
import type { RunClient } from '../engine/run-client'
import { type Anchors, anchorsOf } from '../render/anchors'
import type { Viewport } from '../render/frame'
import { Outlet } from '../render/outlet'
import type { LayersStore } from './layers.svelte'
import type { Camera } from './page-keys'

/** What the first picture did not need comes so many milliseconds after it. */
const PAUSE = 20

/** The run's picture on its way to whom it is drawn by, and what of the plane is seen. */
export class PictureStore {
  /** What the stage shows of the plane, or from where space is seen; null: all of the scene. */
  camera = $state.raw<Camera | null>(null)
  /** What a link wants it to show, until it does. */
  wantedCamera = $state.raw<Camera | 'whole' | null>(null)
  /** What of the newest frame can be pointed at. */
  anchors = $state.raw<Anchors | null>(null)
  /** What the colours of a function's heat map stand for: the first, the middle one and the last. */
  heights = $state.raw<readonly number[]>([])
  /** The first picture is on the screen: what it did not need may come. */
  drawn = $state(false)
  private begun = false
  readonly frames: Outlet

  constructor(
    private readonly client: RunClient,
    private readonly layers: LayersStore,
  ) {
    this.frames = new Outlet(
      (buffer) => client.giveBack(buffer),
      () => void client.want({}),
    )
  }

  /** The frame goes to whom it is drawn by. */
  pass({ frame }: Picture): void {
    const { names } = this.layers
    if (!names) return
    this.anchors = anchorsOf(frame, names)
    this.frames.put(frame, names)
    // In other rooms nothing is drawn.
    if (!this.frames.connected) requestAnimationFrame(this.seen)
  }

  /** The first picture is on the screen. */
  readonly seen = (): void => {
    if (this.begun) return
    this.begun = true
    performance.mark('first-picture')
    // The next frame is the picture's, too.
    setTimeout(() => (this.drawn = true), PAUSE)
    this.client.want({ links: true })
  }

  /** What of the run is seen from now on. */
  see = (viewport: Viewport): void => void this.client.want({ viewport })
}
