import type { Renderer } from './display'
import type { Frame } from './frame'
import type { Names } from './looks'

/** What takes a run's frames. */
export type Sink = Pick<Renderer, 'frame'>

/** Where a run's frames go: to the renderer that is there, or, while there is none, the newest waits for it. */
export class Outlet {
  private sink: Sink | null = null
  private waiting: { frame: Frame; names: Names } | null = null
  /** A renderer that is gone had the newest frame. */
  private taken = false

  /** `release`: of a frame that was drawn for the last time; `again`: asks for the newest frame once more. */
  constructor(
    readonly release: (buffer: ArrayBuffer) => void,
    private readonly again: () => void,
  ) {}

  get connected(): boolean {
    return this.sink !== null
  }

  put(frame: Frame, names: Names): void {
    this.taken = this.sink !== null
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
    if (waiting) {
      this.taken = true
      sink.frame(waiting.frame, waiting.names)
    } else if (this.taken) {
      this.again()
    }
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
