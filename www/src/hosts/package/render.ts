/* `forage-lab/render`: draws runs on a page of one's own, by the code that draws the page. */
import type { DrawingOptions, RunDrawing } from 'forage-lab/render'
import { type Catalogue, catalogue, type Exact, type Planner, type Scene, type Session } from 'forage-lab'
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

/** What is wrong with an option, as the core says it. */
function refused(field: string, value: unknown, allowed: string): never {
  throw Object.assign(new Error(`${field}: ${JSON.stringify(value)} is not allowed; it must be ${allowed}.`), { field, value, allowed })
}

const isPositive = (value: number): boolean => Number.isFinite(value) && value > 0

function check({ size, density, camera, budget }: DrawingOptions): void {
  if (size && !(isPositive(size.width) && isPositive(size.height))) refused('size', size, 'a width and a height above 0')
  if (density !== undefined && !isPositive(density)) refused('density', density, 'a number above 0')
  if (budget !== undefined && !(Number.isSafeInteger(budget) && budget > 0)) refused('budget', budget, 'a whole number above 0')
  const numbers = camera ? ('zoom' in camera ? camera.center : [...camera.target, camera.azimuth, camera.elevation]) : []
  const far = camera ? ('zoom' in camera ? camera.zoom : camera.distance) : 1
  if (!(isPositive(far) && numbers.every(Number.isFinite))) refused('camera', camera, 'finite numbers, with a zoom or a distance above 0')
}

/** What of a session stays as it is. */
interface Known {
  session: Session
  planner: Planner
  names: Names
  scene: Scene
  /** Once it was asked for: it may take a while to find. */
  exact?: Exact | null
}

class Drawing implements RunDrawing {
  private options: DrawingOptions = {}
  private readonly renderer: CanvasRenderer
  private readonly free: ArrayBuffer[] = []
  private known: Known | null = null
  private heights = ''

  constructor(
    private readonly canvas: HTMLCanvasElement | OffscreenCanvas,
    options: DrawingOptions,
  ) {
    this.renderer = new CanvasRenderer(canvas, { onreleased: (buffer) => this.free.push(buffer), ondrawn: () => undefined })
    this.set(options)
  }

  set(options: DrawingOptions): void {
    check(options)
    const { known, options: before } = this
    if (options.catalogue) this.known = null
    this.options = { ...before, ...options }
    try {
      if (known) this.draw(known.session)
    } catch (error) {
      // What is refused changes nothing.
      Object.assign(this, { known, options: before })
      throw error
    }
  }

  draw(session: Session): void {
    const { budget = BUDGET } = this.options
    const known = this.knownOf(session)
    const display = this.displayOf(known)
    const { planner, names } = known
    const shown = layersOf(planner, display.scene.kind, session.parameters).filter(({ role }) => !display.hidden.includes(role))
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
    return this.renderer.files.svg(caption)
  }

  png(density = this.density): Promise<Blob> {
    return this.renderer.files.picture(density)
  }

  dispose(): void {
    this.known = null
    this.renderer.dispose()
  }

  private buffer(bytes: number): ArrayBuffer {
    const kept = this.free.pop()
    return kept && kept.byteLength >= bytes ? kept : new ArrayBuffer(Math.ceil(bytes * 1.25))
  }

  private get all(): Catalogue {
    return this.options.catalogue ?? catalogue()
  }

  /** The scene is the same object for all pictures of a session: what was drawn of it is kept. */
  private knownOf(session: Session): Known {
    if (this.known?.session === session) return this.known
    const { all } = this
    const planner = all.planners.find(({ name }) => name === session.planner)
    if (!planner) return refused('planner', session.planner, `one of the catalogue’s: ${all.planners.map(({ name }) => name).join(', ')}`)
    this.known = { session, planner, names: namesOf(all, planner), scene: session.scene }
    return this.known
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

  private displayOf(known: Known): Display {
    const { options, size, density } = this
    const { session, planner, scene } = known
    const layers = [...planner.layers, ...['margin', 'moving', 'arm'].map((role) => ({ role, on: true }))]
    const names = [...layers.map(({ role }) => role), 'exact']
    const unknown = Object.keys(options.layers ?? {}).find((role) => !names.includes(role))
    if (unknown !== undefined) refused('layers', unknown, `one of ${planner.name}’s: ${names.join(', ')}`)
    const shows = (role: string, on: boolean): boolean => options.layers?.[role] ?? on
    if (shows('exact', true) && known.exact === undefined) known.exact = session.exact()
    const exact = shows('exact', true) ? known.exact : null
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
      hidden: layers.filter(({ role, on }) => !shows(role, on)).map(({ role }) => role),
      overlays,
      highlighted: null,
      details: null,
      followed: false,
      touring: scene.kind === 'tour' || planner.stops,
      playing: false,
      tones: events.map(({ kind }) => planner.events.find(({ name }) => name === kind)?.tone ?? 'plain'),
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
