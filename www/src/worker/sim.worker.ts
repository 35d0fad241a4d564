import * as Comlink from 'comlink'
import init, {
  armSolutions,
  carryOut,
  catalogue,
  exportScene,
  generateScene,
  importScene,
  newSeed,
  parseLink,
  reachability,
  Session,
  suggest,
} from 'forage-lab'
import type {
  ArmSolutions,
  Catalogue,
  Drive,
  Finding,
  Format,
  Imported,
  Inspection,
  Item,
  LinkSetup,
  Motion,
  NamedFile,
  Outcome,
  ParameterValue,
  Point3,
  Reachability,
  Scene,
  Setup,
  Suggestion,
} from 'forage-lab'
import type { Errand } from './crew'
import { oneself, thread } from './hands'
import { breathe } from './pace'
import { Simulation } from './simulation'
import type { Surveyor } from './surveyor'
import type { Answer, FieldRequest, Followed, Look, Opening, Refusal, ReturnedBuffer, Run, Speed } from './protocol'

let simulation: Simulation | undefined
let port: MessagePort | undefined
let surveyor: Surveyor | undefined

/** A trap leaves the module's memory in an unknown state: say so, and let the page start a new worker. */
function crash(error: unknown): void {
  port?.postMessage({ type: 'crash', message: error instanceof Error ? error.message : String(error) })
}

function answer<T>(ask: () => T): Answer<T> {
  try {
    return { ok: true, value: ask() }
  } catch (error) {
    if (error instanceof WebAssembly.RuntimeError) crash(error)
    return { ok: false, refusal: refusal(error) }
  }
}

function refusal(error: unknown): Refusal {
  if (!(error instanceof Error)) return { message: String(error), field: '' }
  const field = 'field' in error && typeof error.field === 'string' ? error.field : ''
  return { message: error.message, field }
}

function running(): Simulation {
  if (!simulation) throw new Error('the core is not loaded yet')
  return simulation
}

const api = {
  /** `hands`: how many threads may work side by side. */
  async open(frames: MessagePort, hands: number): Promise<Catalogue> {
    port = frames
    await init()
    const known = catalogue()
    const tellers = new Set(known.planners.filter(({ events }) => events.length > 0).map(({ name }) => name))
    simulation = new Simulation(frames, crash, known.shapes.indexOf('field'), tellers, async () => {
      const { Crew } = await import('./crew')
      return new Crew(hands, thread, oneself)
    })
    frames.onmessage = ({ data }: MessageEvent<ReturnedBuffer>) => simulation?.giveBack(data.buffer)
    return known
  },
  /** Of a thread that carries out runs for another one. */
  async carryOut(errand: Errand): Promise<Finding> {
    await init()
    return carryOut(errand)
  },
  /** `request`: the page's number of this request, which pictures carry back. */
  start: (setup: Setup, opening: Opening, request: number): Answer<Run> => answer(() => running().start(setup, opening, request)),
  play: (request: number): void => running().play(request),
  pause: (request: number): void => running().pause(request),
  speed: (speed: Speed): void => running().setSpeed(speed),
  seek: (iteration: number, play: boolean, request: number): void => running().seek(iteration, play, request),
  watch: (item: Item | null): void => running().watch(item),
  look: (look: Look): void => running().look(look),
  /** Tells the members' numbers with the pictures, at most so often (in milliseconds); null: not at all. */
  tellMembers: (interval: number | null): void => running().tellMembers(interval),
  inspect: (item: Item): Answer<Inspection | null> => answer(() => current().inspect(item)),
  drive: (params: Record<string, ParameterValue>): Answer<Followed<Drive>> =>
    answer(() => running().follow((session) => session.drive(params))),
  motion: (params: Record<string, ParameterValue>): Answer<Followed<Motion>> =>
    answer(() => running().follow((session) => session.motion(params))),
  /** The postures that bring the tip to a point. */
  armSolutions: (scene: Scene, point: Point3, direction: Point3 | null, near?: number[]): Answer<ArmSolutions> =>
    answer(() => armSolutions(scene, point, direction, near)),
  /** Where the tip can come: computed by another thread, so that this one goes on. Nothing if it was called off. */
  async reach(scene: Scene, step: number): Promise<Answer<Reachability> | null> {
    surveyor ??= new (await import('./surveyor')).Surveyor()
    return surveyor.ask(scene, step)
  },
  callOff: (): void => surveyor?.callOff(),
  /** Of that other thread. */
  async survey(scene: Scene, step: number): Promise<Answer<Reachability>> {
    await init()
    return answer(() => reachability(scene, step))
  },
  pick: (x: number, y: number, reach: number): Item | null => {
    const picked = answer(() => running().session?.pick(x, y, reach) ?? null)
    return picked.ok ? picked.value : null
  },
  importScene: (files: NamedFile[], problem?: number): Answer<Imported> => answer(() => importScene(files, problem)),
  exportScene: (scene: Scene, format: Format): Answer<NamedFile[]> => answer(() => exportScene(scene, format)),
  generateScene: (name: string, params: Record<string, ParameterValue>, seed: number): Answer<Scene> =>
    answer(() => generateScene(name, params, seed)),
  suggest: (setup: Setup): Answer<Suggestion | null> => answer(() => suggest(setup)),
  parseLink: (link: string): Answer<LinkSetup> => answer(() => parseLink(link)),
  newSeed: (): number => newSeed(),
  outcome: (): Answer<Outcome> => answer(() => current().outcome()),
  svg: (dark: boolean, layers: string[]): Answer<string> => answer(() => current().svg(dark, layers)),
  link: (): Answer<string> => answer(() => current().link()),
  csv: (): Answer<string> => answer(() => current().csv()),
  tourFile: (): Answer<NamedFile | null> => answer(() => current().tourFile()),
  async field(request: FieldRequest): Promise<ImageBitmap | null> {
    await breathe()
    return painted(request, current)
  },
  /** A function that is not that of the run. */
  async preview(request: FieldRequest, planner: string): Promise<ImageBitmap | null> {
    await breathe()
    let session: Session | undefined
    const picture = painted(request, () => (session = new Session({ planner, scene: request.scene, seed: 0 })))
    session?.free()
    return picture
  },
}

function painted({ min, max, width, height, dark }: FieldRequest, session: () => Session): ImageBitmap | null {
  const canvas = new OffscreenCanvas(width, height)
  const context = canvas.getContext('2d')
  const done = answer(() => context !== null && session().paintField(context, min, max, dark))
  if (!done.ok || !done.value) return null
  const picture = canvas.transferToImageBitmap()
  return Comlink.transfer(picture, [picture])
}

function current(): Session {
  const { session } = running()
  if (!session) throw new Error('there is no run yet')
  return session
}

export type Api = typeof api
Comlink.expose(api)
