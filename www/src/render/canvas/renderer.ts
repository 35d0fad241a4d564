import type { Item, Point } from 'forage-lab'
import { anchorsOf } from '../anchors'
import { asking } from '../asking'
import type { CanvasFiles, Display, Ground, Renderer, RendererListeners } from '../display'
import type { Frame } from '../frame'
import type { Names } from '../looks'
import { Palette } from '../palette'
import type { Files, Seen } from './files'
import { Painter, type Present } from './painter'
import type { Context, Pen } from './pen'

/** Draws scenes and frames on a canvas of two dimensions: of the page, or of a thread. */
export class CanvasRenderer implements Renderer {
  private readonly context: Context | null
  private readonly painter: Painter
  private display: Display | null = null
  private present: Present | null = null
  private heat: Ground | null = null
  private backdrop: { sheet: OffscreenCanvas; key: readonly unknown[] } | null = null
  private request = 0
  /** A recording is under way. */
  private filming = false
  private saved: Promise<Files> | undefined
  /** They come with the first that is wanted. */
  readonly files = asking<CanvasFiles>(async (name, given) => {
    this.saved ??= import('./files').then(({ Files }) => new Files(() => this.seen))
    const files = await this.saved
    this.filming = name === 'film' || (this.filming && name !== 'cut')
    return (files[name] as (...given: unknown[]) => Promise<unknown>)(...given)
  })
  private drawn = false

  constructor(
    private readonly canvas: HTMLCanvasElement | OffscreenCanvas,
    private readonly listeners: RendererListeners,
  ) {
    this.context = canvas.getContext('2d') as Context | null
    this.painter = new Painter(
      () => this.soon(),
      (state) => listeners.onspace?.(state),
    )
  }

  show(display: Display): void {
    this.display = display
    this.soon()
  }

  frame(frame: Frame, names: Names): void {
    this.release()
    this.present = { frame, names, anchors: anchorsOf(frame, names) }
    this.soon()
  }

  /** All is drawn once more. */
  refresh(): void {
    this.backdrop = null
    this.soon()
  }

  ground(ground: Ground | null): void {
    this.heat?.bitmap.close()
    this.heat = ground
    this.soon()
  }

  async nearest(at: Point, reach: number, layers: readonly string[]): Promise<Item | null> {
    return this.painter.nearest(this.display, at, reach, layers)
  }

  dispose(): void {
    this.painter.drop()
    void this.saved?.then((files) => files.drop())
    if (this.request !== 0) cancelAnimationFrame(this.request)
    this.heat?.bitmap.close()
    this.release()
  }

  private get seen(): Seen {
    const { display, present, heat } = this
    if (!display) throw new Error('nothing is shown yet')
    return { display, present, heat }
  }

  private release(): void {
    const { present } = this
    this.present = null
    if (!present) return
    for (const { bitmap } of present.frame.fields) bitmap.close()
    this.listeners.onreleased(present.frame.buffer)
  }

  private soon(): void {
    // Nobody looks at what is recorded.
    if (this.request !== 0 || this.filming) return
    this.request = requestAnimationFrame(() => {
      this.request = 0
      this.draw()
    })
  }

  private draw(): void {
    const { canvas, context, display } = this
    if (!context || !display) return
    const { size, density, view } = display
    const [width, height] = [Math.round(size.width * density), Math.round(size.height * density)]
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height })
    const pen: Pen = { context, view, size, density, palette: new Palette(display.theme) }
    this.drawBackdrop(pen, display)
    const whole = this.painter.above(pen, display, this.present)
    if (!whole || !this.present || this.drawn) return
    this.drawn = true
    this.listeners.ondrawn()
  }

  /** What lies beneath the frame, kept as a picture: a run draws it sixty times a second. */
  private drawBackdrop(pen: Pen, display: Display): void {
    const { context, size, density } = pen
    const { scene, view, theme, blamed, hidden } = display
    const key = [scene, view, size, density, theme, blamed, this.heat, hidden.includes('height')]
    if (!this.backdrop || key.some((part, at) => part !== this.backdrop?.key[at])) {
      const [width, height] = [Math.max(1, this.canvas.width), Math.max(1, this.canvas.height)]
      // A new one each time: browsers draw the first picture on a canvas with other shades than the following ones.
      const sheet = new OffscreenCanvas(width, height)
      const own = sheet.getContext('2d')
      if (!own) return
      this.backdrop = { sheet, key }
      own.setTransform(density, 0, 0, density, 0, 0)
      this.painter.beneath({ ...pen, context: own }, display, this.heat)
    }
    context.setTransform(1, 0, 0, 1, 0, 0)
    context.drawImage(this.backdrop.sheet, 0, 0)
    context.setTransform(density, 0, 0, density, 0, 0)
  }
}
