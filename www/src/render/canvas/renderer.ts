import type { Item, Point } from 'forage-lab'
import { anchorsOf } from '../anchors'
import type { Display, Filming, Footer, Ground, Looks, Renderer, RendererListeners } from '../display'
import type { Encoder, FilmContext } from '../film/encoder'
import type { Frame } from '../frame'
import type { Names } from '../looks'
import { Palette } from '../palette'
import { fit, margins } from '../view'
import { drawAxisTitles } from './ground'
import { Painter, partsLoaded, type Present } from './painter'
import type { Context, Pen } from './pen'

/** Pictures in a file of lines and areas have so many pixels a pixel of the page. */
const SHARP = 2

/** What stands below a picture; nothing has no height. */
async function sheetOf(footer: Footer | undefined, width: number): Promise<{ height: number; draw(pen: Pen, top: number): void }> {
  if (!footer) return { height: 0, draw: () => undefined }
  const { drawFooter, laidOut } = await import('./footer')
  const sheet = laidOut(footer, width)
  return { height: sheet.height, draw: (pen, top) => drawFooter(pen, sheet, top) }
}

/** Draws scenes and frames on a canvas of two dimensions: of the page, or of a thread. */
export class CanvasRenderer implements Renderer {
  private readonly context: Context | null
  private readonly painter: Painter
  private display: Display | null = null
  private present: Present | null = null
  private heat: Ground | null = null
  private backdrop: { sheet: OffscreenCanvas; key: readonly unknown[] } | null = null
  private request = 0
  private filming: { context: FilmContext; density: number; encoder: Encoder; painter: Painter } | null = null
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

  async svg(caption: string, looks: Looks = {}): Promise<string> {
    const { VectorContext } = await import('../vector/context')
    const display = await flat(this.shown(looks))
    const { width, height } = display.size
    const below = await sheetOf(looks.footer, width)
    const painter = new Painter(() => undefined)
    const file = await this.painted(() => new VectorContext(width, height + below.height, SHARP), display, SHARP, painter)
    below.draw(this.penOn(file, display, SHARP), height)
    painter.drop()
    return file.svg(caption)
  }

  async picture(density: number, looks: Looks = {}): Promise<Blob> {
    const display = this.shown(looks)
    const { width, height } = display.size
    const below = await sheetOf(looks.footer, width)
    const whole = height + below.height
    const sheet = new OffscreenCanvas(Math.max(1, Math.round(width * density)), Math.max(1, Math.round(whole * density)))
    // Grids and space are drawn on canvases of their own: those of another size are another painter's.
    const painter = new Painter(() => undefined)
    const context = await this.painted(() => contextOf(sheet), { ...display, density }, density, painter)
    below.draw(this.penOn(context, display, density), height)
    painter.drop()
    return sheet.convertToBlob()
  }

  async film({ format, density, rate, footer }: Filming): Promise<void> {
    const [{ encoderOf, even }, { size }] = [await import('../film/film'), this.shown()]
    const below = await sheetOf(footer, size.width)
    const sheet = new OffscreenCanvas(even(size.width * density), even((size.height + below.height) * density))
    // Drawn without a graphics card: the same pictures are the same pixels.
    const context = contextOf(sheet, { willReadFrequently: true })
    context.fillStyle = new Palette(this.shown().theme).get('--stage')
    context.fillRect(0, 0, sheet.width, sheet.height)
    this.filming = { context, density, encoder: await encoderOf(format, context, rate), painter: new Painter(() => undefined) }
  }

  async shoot(footer?: Footer): Promise<void> {
    const { filming } = this
    if (!filming) throw new Error('nothing is recorded')
    const { context, density, painter, encoder } = filming
    const display = this.shown()
    const below = await sheetOf(footer, display.size.width)
    await this.painted(() => context, { ...display, density }, density, painter)
    below.draw(this.penOn(context, display, density), display.size.height)
    await encoder.add()
  }

  async cut(): Promise<Blob> {
    const { filming } = this
    if (!filming) throw new Error('nothing is recorded')
    this.filming = null
    filming.painter.drop()
    return filming.encoder.end()
  }

  async nearest(at: Point, reach: number, layers: readonly string[]): Promise<Item | null> {
    return this.painter.nearest(this.display, at, reach, layers)
  }

  dispose(): void {
    this.painter.drop()
    this.filming?.painter.drop()
    void this.filming?.encoder.cancel()
    this.filming = null
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
    // Nobody looks at what is recorded.
    if (this.request !== 0 || this.filming) return
    this.request = requestAnimationFrame(() => {
      this.request = 0
      this.draw()
    })
  }

  private shown({ theme }: Looks = {}): Display {
    if (!this.display) throw new Error('nothing is shown yet')
    return theme ? { ...this.display, theme: { ...this.display.theme, ...theme } } : this.display
  }

  /** All of the picture on something else, with all that it needs. */
  private async painted<C extends Context>(make: () => C, display: Display, density: number, painter: Painter): Promise<C> {
    for (;;) {
      const context = make()
      const pen = this.penOn(context, display, density)
      context.setTransform(density, 0, 0, density, 0, 0)
      painter.beneath(pen, display, this.heat)
      if (painter.above(pen, display, this.present)) {
        drawAxisTitles(pen, display.scene)
        return context
      }
      await partsLoaded()
    }
  }

  private penOn(context: Context, display: Display, density: number): Pen {
    return { ...display, context, density, palette: new Palette(display.theme) }
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

function contextOf(sheet: OffscreenCanvas, settings?: CanvasRenderingContext2DSettings): OffscreenCanvasRenderingContext2D {
  const context = sheet.getContext('2d', settings)
  if (!context) throw new Error('this browser gives no canvas')
  return context
}

/** What is seen in space as lines and areas in the plane: in parallel projection, from where it is seen. */
async function flat(display: Display): Promise<Display> {
  const { scene, size, orbit, posture } = display
  if (!orbit || scene.kind !== 'arm') return display
  const [{ flattened }, { home, stance }] = await Promise.all([import('../space/projection'), import('../space/kinematics')])
  const { skeleton } = stance(scene.arm, posture ?? home(scene.arm))
  const angles = { azimuth: orbit.azimuth, elevation: orbit.elevation }
  const view = fit(flattened(scene, skeleton, angles).bounds, size, margins(size.width, true))
  return { ...display, orbit: undefined, view, space: { angles, skeleton } }
}
