import type { CanvasFiles, Display, Filming, Footer, Ground, Looks } from '../display'
import type { Encoder, FilmContext } from '../film/encoder'
import { Palette } from '../palette'
import type { Point3 } from 'forage-lab'
import { times } from '../../scene/vector'
import { fit, toScreen } from '../view'
import { drawAxisTitles } from './ground'
import { Painter, partsLoaded, type Present } from './painter'
import type { Context, Pen } from './pen'

/** Pictures in a file of lines and areas have so many pixels a pixel of the page. */
const SHARP = 2
/** Around a workspace, for the numbers of its axes, in pixels. */
const ROOM = [72, 56] as const
/** In metres: as from afar. */
const FAR = 1000

/** What stands below a picture; nothing has no height. */
async function sheetOf(footer: Footer | undefined, width: number): Promise<{ height: number; draw(pen: Pen, top: number): void }> {
  if (!footer) return { height: 0, draw: () => undefined }
  const { drawFooter, laidOut } = await import('./footer')
  const sheet = laidOut(footer, width)
  return { height: sheet.height, draw: (pen, top) => drawFooter(pen, sheet, top) }
}

/** What a canvas shows at the moment. */
export interface Seen {
  display: Display
  present: Present | null
  heat: Ground | null
}

/** What a canvas shows, as files: pictures, drawings and recordings. */
export class Files implements CanvasFiles {
  private filming: { context: FilmContext; density: number; encoder: Encoder; painter: Painter } | null = null

  constructor(private readonly seen: () => Seen) {}

  readonly svg = async (caption: string, looks: Looks = {}): Promise<string> => {
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

  readonly picture = async (density: number, looks: Looks = {}): Promise<Blob> => {
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

  readonly film = async ({ format, density, rate, footer }: Filming): Promise<void> => {
    const [{ encoderOf, even }, { size }] = [await import('../film/film'), this.shown()]
    const below = await sheetOf(footer, size.width)
    const sheet = new OffscreenCanvas(even(size.width * density), even((size.height + below.height) * density))
    // Drawn without a graphics card: the same pictures are the same pixels.
    const context = contextOf(sheet, { willReadFrequently: true })
    context.fillStyle = new Palette(this.shown().theme).get('--stage')
    context.fillRect(0, 0, sheet.width, sheet.height)
    this.filming = { context, density, encoder: await encoderOf(format, context, rate), painter: new Painter(() => undefined) }
  }

  readonly shoot = async (footer?: Footer): Promise<void> => {
    const { filming } = this
    if (!filming) throw new Error('nothing is recorded')
    const { context, density, painter, encoder } = filming
    const display = this.shown()
    const below = await sheetOf(footer, display.size.width)
    await this.painted(() => context, { ...display, density }, density, painter)
    below.draw(this.penOn(context, display, density), display.size.height)
    await encoder.add()
  }

  readonly cut = async (): Promise<Blob> => {
    const { filming } = this
    if (!filming) throw new Error('nothing is recorded')
    this.filming = null
    filming.painter.drop()
    return filming.encoder.end()
  }

  drop(): void {
    this.filming?.painter.drop()
    void this.filming?.encoder.cancel()
    this.filming = null
  }

  private shown({ theme }: Looks = {}): Display {
    const { display } = this.seen()
    return theme ? { ...display, theme: { ...display.theme, ...theme } } : display
  }

  /** All of the picture on something else, with all that it needs. */
  private async painted<C extends Context>(make: () => C, display: Display, density: number, painter: Painter): Promise<C> {
    for (;;) {
      const { heat, present } = this.seen()
      const context = make()
      const pen = this.penOn(context, display, density)
      context.setTransform(density, 0, 0, density, 0, 0)
      painter.beneath(pen, display, heat)
      if (painter.above(pen, display, present)) {
        drawAxisTitles(pen, display.scene)
        await drawMetres(pen, display)
        return context
      }
      await partsLoaded()
    }
  }

  private penOn(context: Context, display: Display, density: number): Pen {
    return { ...display, context, density, palette: new Palette(display.theme) }
  }
}

function contextOf(sheet: OffscreenCanvas, settings?: CanvasRenderingContext2DSettings): OffscreenCanvasRenderingContext2D {
  const context = sheet.getContext('2d', settings)
  if (!context) throw new Error('this browser gives no canvas')
  return context
}

/** The numbers of an arm's axes, where it is seen in parallel projection. */
async function drawMetres(pen: Pen, { scene, space }: Display): Promise<void> {
  if (scene.kind !== 'arm' || !space) return
  const [{ drawAxes }, { seen }, { basis }] = await Promise.all([
    import('../space/labels'),
    import('../space/projection'),
    import('../space/orbit'),
  ])
  const to = seen(space.angles)
  const project = (point: Point3): { x: number; y: number } => {
    const [x, y] = toScreen(pen.view, pen.size, to(point))
    return { x, y }
  }
  drawAxes(pen, { eye: times(basis(space.angles)[2], FAR), project }, scene.workspace)
}

/** What is seen in space as lines and areas in the plane: in parallel projection, from where it is seen. */
async function flat(display: Display): Promise<Display> {
  const { scene, size, orbit, posture } = display
  if (!orbit || scene.kind !== 'arm') return display
  const [{ flattened }, { home, stance }] = await Promise.all([import('../space/projection'), import('../space/kinematics')])
  const { skeleton } = stance(scene.arm, posture ?? home(scene.arm))
  const angles = { azimuth: orbit.azimuth, elevation: orbit.elevation }
  const view = fit(flattened(scene, skeleton, angles).bounds, size, ROOM)
  return { ...display, orbit: undefined, view, space: { angles, skeleton } }
}
