/* `forage-lab/render`: draws runs on a page of one's own, by the code that draws the page. */
import type { DrawingOptions, RunDrawing } from 'forage-lab/render'
import { type Catalogue, catalogue, type Planner, type Session } from 'forage-lab'
import { layersOf } from '../../catalogue/parameters'
import { fieldsOf } from '../../engine/host/fields'
import { pack } from '../../engine/host/pack'
import { CanvasRenderer } from '../../render/canvas/renderer'
import type { Display, InSpace, Overlay } from '../../render/display'
import { layerOf, type Names, namesOf, PLAIN, rampOf } from '../../render/looks'
import { home, whole } from '../../render/space/kinematics'
import { fit as fitSpace, SIDES } from '../../render/space/orbit'
import { extent, fit, isDown, type Size, toScene, type View } from '../../render/view'
import { viewportOf } from '../../render/viewport'

/** Pixels about what is drawn. */
const MARGINS = [30, 28] as const
/** Heights are sampled so finely, in pixels of the picture a side. */
const FINEST = 700
const BUDGET = 40_000

class Drawing implements RunDrawing {
  private options: DrawingOptions = {}
  private readonly renderer: CanvasRenderer
  private readonly free: ArrayBuffer[] = []
  private session: Session | null = null
  private known: { planner: Planner | undefined; names: Names } | null = null
  private heights = ''

  constructor(
    private readonly canvas: HTMLCanvasElement | OffscreenCanvas,
    options: DrawingOptions,
  ) {
    this.renderer = new CanvasRenderer(canvas, { onreleased: (buffer) => this.free.push(buffer), ondrawn: () => undefined })
    this.set(options)
  }

  set(options: DrawingOptions): void {
    if (options.catalogue) this.known = null
    this.options = { ...this.options, ...options }
    if (this.session) this.draw(this.session)
  }

  draw(session: Session): void {
    this.session = session
    const { budget = BUDGET } = this.options
    const display = this.displayOf(session)
    const { planner, names } = this.layersOf(session.planner)
    const shown = planner
      ? layersOf(planner, display.scene.kind, session.parameters).filter(({ role }) => !display.hidden.includes(role))
      : []
    const viewport = viewportOf(display.orbit ? [] : shown, display.view, display.size, display.theme.dark)
    session.lookAt(viewport.window?.min, viewport.window?.max)
    // The views last until the next call: nothing of the core may come between here and the copy.
    const { vertices, spans } = session.frame(budget)
    const packed = pack(vertices, spans, names.shapes.indexOf('field'), (bytes) => this.buffer(bytes))
    this.renderer.frame({ ...packed, fields: fieldsOf(session, viewport.fields) }, names)
    this.renderer.show(display)
    this.paintHeights(session, display)
  }

  svg(caption = ''): Promise<string> {
    return this.renderer.svg(caption)
  }

  png(density = this.density): Promise<Blob> {
    return this.renderer.picture(density)
  }

  dispose(): void {
    this.session = null
    this.renderer.dispose()
  }

  private buffer(bytes: number): ArrayBuffer {
    const kept = this.free.pop()
    return kept && kept.byteLength >= bytes ? kept : new ArrayBuffer(Math.ceil(bytes * 1.25))
  }

  private get all(): Catalogue {
    return this.options.catalogue ?? catalogue()
  }

  private layersOf(name: string): { planner: Planner | undefined; names: Names } {
    if (this.known?.planner?.name !== name) {
      const { all } = this
      const planner = all.planners.find((candidate) => candidate.name === name)
      this.known = { planner, names: namesOf(all, planner) }
    }
    return this.known as { planner: Planner | undefined; names: Names }
  }

  private get density(): number {
    return this.options.density ?? ('clientWidth' in this.canvas ? devicePixelRatio || 1 : 1)
  }

  private get size(): Size {
    const { options, canvas, density } = this
    if (options.size) return options.size
    if ('clientWidth' in canvas && canvas.clientWidth > 0) return { width: canvas.clientWidth, height: canvas.clientHeight }
    return { width: canvas.width / density, height: canvas.height / density }
  }

  private displayOf(session: Session): Display {
    const { options, size, density } = this
    const { scene } = session
    const { planner } = this.layersOf(session.planner)
    const shows = (role: string, on: boolean): boolean => options.layers?.[role] ?? on
    const exact = shows('exact', true) ? session.exact() : null
    const points = scene.kind === 'arm' ? exact?.tip_path : exact?.path
    const overlays: Overlay[] = points ? [{ points, look: layerOf(this.all, null, 'exact')?.look ?? PLAIN }] : []
    const events = session.events()
    return {
      scene,
      view: this.viewOf(scene, size),
      size,
      density,
      theme: { dark: options.dark ?? false },
      fits: true,
      faded: false,
      hidden: [...(planner?.layers ?? []), { role: 'margin', on: true }, { role: 'moving', on: true }, { role: 'arm', on: true }]
        .filter(({ role, on }) => !shows(role, on))
        .map(({ role }) => role),
      overlays,
      details: null,
      followed: false,
      touring: scene.kind === 'tour' || (planner?.stops ?? false),
      playing: false,
      tones: events.map(({ kind }) => planner?.events.find(({ name }) => name === kind)?.tone ?? 'plain'),
      selection: null,
      hover: null,
      blamed: null,
      cell: null,
      words: options.labels ?? { start: 'start', goal: 'goal' },
      space: null,
      ...(scene.kind === 'arm' && this.roomOf(scene, size)),
    }
  }

  private viewOf(scene: Session['scene'], size: Size): View {
    const { camera } = this.options
    const all = fit(extent(scene), size, MARGINS, isDown(scene))
    if (!camera || !('zoom' in camera)) return all
    return { ...all, x: camera.center[0], y: camera.center[1], scale: all.scale * camera.zoom }
  }

  private roomOf(scene: Extract<Session['scene'], { kind: 'arm' }>, size: Size): InSpace {
    const { camera } = this.options
    const orbit = camera && 'target' in camera ? camera : fitSpace(whole(scene.workspace, scene.arm), size, MARGINS, SIDES.corner)
    return {
      orbit,
      posture: home(scene.arm),
      touching: false,
      thickness: 0,
      ghosts: null,
      ghost: null,
      reach: null,
      pointed: null,
      chosen: null,
      grip: null,
      held: false,
    }
  }

  /** The landscape of a function, once for each view of it. */
  private paintHeights(session: Session, { scene, view, size, theme }: Display): void {
    const key = scene.kind === 'function' ? JSON.stringify([scene, view, size, theme]) : ''
    if (key === this.heights) return
    this.heights = key
    const fine = Math.min(1, FINEST / Math.max(size.width, size.height))
    const sheet = new OffscreenCanvas(Math.max(1, Math.round(size.width * fine)), Math.max(1, Math.round(size.height * fine)))
    const [context, [left, top], [right, bottom]] = [
      sheet.getContext('2d'),
      toScene(view, size, [0, 0]),
      toScene(view, size, [size.width, size.height]),
    ]
    const painted = key !== '' && context && session.paintField(context, [left, bottom], [right, top], rampOf(this.all.heights, theme.dark))
    this.renderer.ground(painted ? { bitmap: sheet.transferToImageBitmap(), box: { min: [left, bottom], max: [right, top] } } : null)
  }
}

/** Draws runs on this canvas, of a page or of a worker, which nothing else has drawn. */
export const drawOn = (canvas: HTMLCanvasElement | OffscreenCanvas, options: DrawingOptions = {}): RunDrawing =>
  new Drawing(canvas, options)
