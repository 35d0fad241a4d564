import type { Renderer } from './display'
import type { Frame } from './frame'
import type { Names } from './looks'

/** What takes a run's frames. */
export type Sink = Pick<Renderer, 'frame'>

/** Where a run's frames go: to the renderer that is there, or, while there is none, the newest waits for it. */
export class Outlet {
  private sink: Sink | null = null
  private waiting: { frame: Frame; names: Names } | null = null

  /** `release`: of a frame that was drawn for the last time. */
  constructor(readonly release: (buffer: ArrayBuffer) => void) {}

  get connected(): boolean {
    return this.sink !== null
  }

  put(frame: Frame, names: Names): void {
    if (this.sink) {
      this.sink.frame(frame, names)
      return
    }
    this.clear()
    this.waiting = { frame, names }
  }

  /** Returns what ends it. */
  connect(sink: Sink): () => void {
    this.sink = sink
    const { waiting } = this
    this.waiting = null
    if (waiting) sink.frame(waiting.frame, waiting.names)
    return () => {
      if (this.sink === sink) this.sink = null
    }
  }

  /** What waits is of another run. */
  clear(): void {
    if (this.waiting) this.pass(this.waiting.frame)
    this.waiting = null
  }

  /** A frame that is not drawn. */
  pass({ buffer, fields }: Frame): void {
    for (const { bitmap } of fields) bitmap.close()
    this.release(buffer)
  }
}
