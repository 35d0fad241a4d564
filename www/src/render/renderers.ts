import { useLetters } from './canvas/letters'
import type { Item, Point } from 'forage-lab'
import { asking } from './asking'
import type { CanvasFiles, Display, Ground, Renderer, RendererListeners } from './display'
import type { Frame } from './frame'
import type { Names } from './looks'
import type { Answer, Asked, FromRenderer, ToRenderer } from './protocol'

type Unaddressed<M> = M extends unknown ? Omit<M, 'canvas'> : never

/** Draws a canvas in the thread that it is given to. */
class RemoteRenderer implements Renderer {
  private shown: Partial<Display> = {}
  private names: Names | undefined
  private readonly waiting = new Map<number, { resolve(value: unknown): void; reject(error: Error): void }>()
  private asked = 0
  private disposed = false

  constructor(private readonly send: (message: Unaddressed<ToRenderer>, transfer?: Transferable[]) => void) {}

  /** Only what has changed is sent. */
  show(display: Display): void {
    const { shown } = this
    const changed = Object.entries(display).filter(([key, value]) => !(key in shown) || shown[key as keyof Display] !== value)
    this.shown = display
    if (changed.length > 0) this.send({ is: 'show', change: Object.fromEntries(changed) })
  }

  frame(frame: Frame, names: Names): void {
    const transfer = [frame.buffer, ...frame.fields.map(({ bitmap }) => bitmap)]
    this.send({ is: 'frame', frame, ...(names !== this.names && { names }) }, transfer)
    this.names = names
  }

  ground(ground: Ground | null): void {
    this.send({ is: 'ground', ground }, ground ? [ground.bitmap] : [])
  }

  readonly files = asking<CanvasFiles>((name, given) => this.ask({ for: name, given }))

  nearest(at: Point, reach: number, layers: readonly string[]): Promise<Item | null> {
    return this.ask({ for: 'nearest', at, reach, layers })
  }

  private ask<T>(asked: Asked): Promise<T> {
    if (this.disposed) return Promise.reject(new Error('the canvas is gone'))
    this.asked += 1
    const id = this.asked
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve: (value) => resolve(value as T), reject })
      this.send({ is: 'ask', id, ...asked })
    })
  }

  /** What the thread says; null: it will say nothing. */
  answer(answer: Answer | null): void {
    if (!answer) {
      for (const { reject } of this.waiting.values()) reject(new Error('the thread that draws broke down'))
      this.waiting.clear()
      return
    }
    const waiting = this.waiting.get(answer.id)
    this.waiting.delete(answer.id)
    if (answer.is === 'answer') waiting?.resolve(answer.value)
    else waiting?.reject(new Error(answer.message))
  }

  dispose(): void {
    this.disposed = true
    this.send({ is: 'close' })
    this.answer(null)
  }
}

interface Listeners extends RendererListeners {
  /** The thread broke down and took the canvas along: another one may be opened. */
  onlost(): void
}

/** Opens renderers: in one thread for all canvases of a page, or, where there can be none, where the page is. */
export class Renderers {
  private worker: Worker | undefined
  private readonly canvases = new Map<number, { listeners: Listeners; frames: number; renderer: RemoteRenderer }>()
  private opened = 0
  /** No thread draws here. */
  private alone = false
  private probe: Promise<boolean> | undefined
  private probed: ((able: boolean) => void) | undefined
  /** Of the letters. */
  private address = ''
  private lettered: (() => void) | undefined

  /** `start` starts a thread. */
  constructor(private readonly start: () => Worker) {}

  /** A renderer of a canvas that nothing else has drawn; `space`: of one that shows space, which not all threads can draw. */
  async open(canvas: HTMLCanvasElement, listeners: Listeners, space = false): Promise<Renderer> {
    const away = 'transferControlToOffscreen' in canvas && (!space || (await this.drawsSpace()))
    const worker = away ? this.thread() : undefined
    if (!worker) {
      const { CanvasRenderer } = await import('./canvas/renderer')
      return new CanvasRenderer(canvas, listeners)
    }
    this.opened += 1
    const number = this.opened
    const send = (message: Unaddressed<ToRenderer>, transfer: Transferable[] = []): void => {
      const isFrame = message.is === 'frame'
      if (worker !== this.worker) {
        if (message.is === 'ask') opened.renderer.answer(null)
        if (isFrame) listeners.onreleased(message.frame.buffer)
        return
      }
      if (isFrame) opened.frames += 1
      worker.postMessage({ ...message, canvas: number }, transfer)
    }
    const element = canvas.transferControlToOffscreen()
    const opened = { listeners, frames: 0, renderer: new RemoteRenderer(send) }
    this.canvases.set(number, opened)
    send({ is: 'open', element }, [element])
    return opened.renderer
  }

  /** Gives the thread the letters at this address; resolves when it has them; one that starts later gets them, too. */
  letters(address: string): Promise<void> {
    this.address = address
    // Where the page draws itself, it has them.
    useLetters()
    if (!this.worker) return Promise.resolve()
    return new Promise((resolve) => {
      this.lettered = resolve
      this.sendLetters()
    })
  }

  private sendLetters(): void {
    const { address } = this
    if (address) this.worker?.postMessage({ is: 'letters', address, canvas: 0 } satisfies ToRenderer)
  }

  /** Whether a thread can draw space. A canvas that was given away cannot be taken back: it is asked before. */
  private drawsSpace(): Promise<boolean> {
    const worker = this.thread()
    if (!worker) return Promise.resolve(false)
    this.probe ??= new Promise((resolve) => {
      this.probed = resolve
      worker.postMessage({ is: 'probe', canvas: 0 } satisfies ToRenderer)
    })
    return this.probe
  }

  private thread(): Worker | undefined {
    if (this.worker || this.alone) return this.worker
    try {
      this.worker = this.start()
    } catch {
      this.alone = true
      return undefined
    }
    this.sendLetters()
    this.worker.onmessage = ({ data }: MessageEvent<FromRenderer>) => this.receive(data)
    this.worker.onerror = (event) => {
      event.preventDefault()
      this.lose()
    }
    return this.worker
  }

  private receive(message: FromRenderer): void {
    if (message.is === 'probed') {
      this.probed?.(message.able)
      return
    }
    if (message.is === 'lettered') {
      this.lettered?.()
      return
    }
    const opened = this.canvases.get(message.canvas)
    if (!opened) return
    if (message.is === 'closed') this.canvases.delete(message.canvas)
    else if (message.is === 'drawn') opened.listeners.ondrawn()
    else if (message.is === 'space') opened.listeners.onspace?.(message.state)
    else if (message.is === 'answer' || message.is === 'refused') opened.renderer.answer(message)
    else {
      opened.frames -= 1
      opened.listeners.onreleased(message.buffer)
    }
  }

  /** What broke down once is not started again. */
  private lose(): void {
    this.alone = true
    this.probed?.(false)
    this.lettered?.()
    this.worker?.terminate()
    this.worker = undefined
    const lost = [...this.canvases.values()]
    this.canvases.clear()
    for (const { listeners, frames, renderer } of lost) {
      renderer.answer(null)
      // Their buffers are gone; runs wait for as many.
      for (let frame = 0; frame < frames; frame += 1) listeners.onreleased(new ArrayBuffer(0))
      listeners.onlost()
    }
  }
}
