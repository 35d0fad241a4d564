import { anchorsOf } from '../anchors'
import type { Display, Ground, Renderer, RendererListeners } from '../display'
import type { Frame } from '../frame'
import type { Names } from '../looks'
import { Palette } from '../palette'
import { Painter, partsLoaded, type Present } from './painter'
import type { Context, Pen } from './pen'

/** Pictures in a file of lines and areas have so many pixels a pixel of the page. */
const SHARP = 2

/** Draws scenes and frames on a canvas of two dimensions: of the page, or of a thread. */
export class CanvasRenderer implements Renderer {
  private readonly context: Context | null
  private readonly painter = new Painter(() => this.soon())
  private display: Display | null = null
  private present: Present | null = null
  private heat: Ground | null = null
  private backdrop: { sheet: OffscreenCanvas; key: readonly unknown[] } | null = null
  private request = 0
  private drawn = false

  constructor(
    private readonly canvas: HTMLCanvasElement | OffscreenCanvas,
    private readonly listeners: RendererListeners,
  ) {
    this.context = canvas.getContext('2d') as Context | null
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

  ground(ground: Ground | null): void {
    this.heat?.bitmap.close()
    this.heat = ground
    this.soon()
  }

  async svg(caption: string): Promise<string> {
    const { VectorContext } = await import('../vector/context')
    await this.complete()
    if (!this.display) throw new Error('nothing is shown yet')
    const { width, height } = this.display.size
    const file = new VectorContext(width, height, SHARP)
    this.paint(file, this.display, SHARP)
    return file.svg(caption)
  }

  async picture(density: number): Promise<Blob> {
    await this.complete()
    if (!this.display) throw new Error('nothing is shown yet')
    const { width, height } = this.display.size
    const sheet = new OffscreenCanvas(Math.max(1, Math.round(width * density)), Math.max(1, Math.round(height * density)))
    const context = sheet.getContext('2d')
    if (!context) throw new Error('this browser gives no canvas')
    // Grids are drawn on canvases of their own: those of another size are another painter's.
    this.paint(context, this.display, density, new Painter(() => undefined))
    return sheet.convertToBlob()
  }

  dispose(): void {
    if (this.request !== 0) cancelAnimationFrame(this.request)
    this.heat?.bitmap.close()
    this.release()
  }

  private release(): void {
    const { present } = this
    this.present = null
    if (!present) return
    for (const { bitmap } of present.frame.fields) bitmap.close()
    this.listeners.onreleased(present.frame.buffer)
  }

  private soon(): void {
    if (this.request !== 0) return
    this.request = requestAnimationFrame(() => {
      this.request = 0
      this.draw()
    })
  }

  /** All that the picture needs is there. */
  private async complete(): Promise<void> {
    // What is asked for while drawing is known once something was drawn.
    this.draw()
    await partsLoaded()
  }

  /** All of the picture, on something else. */
  private paint(context: Context, display: Display, density: number, painter = this.painter): void {
    const pen: Pen = { ...display, context, density, palette: new Palette(display.theme) }
    context.setTransform(density, 0, 0, density, 0, 0)
    painter.beneath(pen, display, this.heat)
    painter.above(pen, display, this.present)
  }

  private draw(): void {
    const { canvas, context, display } = this
    if (!context || !display) return
    const { size, density, view } = display
    const [width, height] = [Math.round(size.width * density), Math.round(size.height * density)]
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height })
    const pen: Pen = { context, view, size, density, palette: new Palette(display.theme) }
    this.drawBackdrop(pen, display)
    this.painter.above(pen, display, this.present)
    if (!this.present || this.drawn) return
    this.drawn = true
    this.listeners.ondrawn()
  }

  /** What lies beneath the frame, kept as a picture: a run draws it sixty times a second. */
  private drawBackdrop(pen: Pen, display: Display): void {
    const { context, size, density } = pen
    const { scene, view, theme, blamed } = display
    const key = [scene, view, size, density, theme, blamed, this.heat]
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
