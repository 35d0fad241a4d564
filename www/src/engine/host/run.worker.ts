import * as Comlink from 'comlink'
import {
  armSolutions,
  begin,
  carryOut,
  exportScene,
  generateScene,
  importScene,
  ModuleDead,
  newSeed,
  parseLink,
  reachability,
  Session,
  suggest,
} from 'forage-lab/core'
import type {
  ArmSolutions,
  Drive,
  Finding,
  Format,
  GeneratorName,
  Imported,
  Inspection,
  Item,
  LayerName,
  LinkSetup,
  Motion,
  NamedFile,
  Outcome,
  ParameterValue,
  PlannerName,
  Point3,
  Reachability,
  Scene,
  Setup,
  Suggestion,
  UncheckedSetup,
} from 'forage-lab'
import type { Errand } from './subtasks'
import { oneself, thread } from './threads'
import { causeOf, refusalOf } from './refusal'
import { breathe } from './pace'
import { rest, words } from './rest'
import { Simulation } from './run-host'
import type { Surveyor } from './reachability'
import type { FieldRequest, Viewport } from '../../render/frame'
import type { Answer, Followed, Opening, ReturnedBuffer, Run, Speed } from '../protocol'

let simulation: Simulation | undefined
let port: MessagePort | undefined
let surveyor: Surveyor | undefined
let onFirstStart: (start: Promise<unknown>) => void
/** The newest start; what is asked of a run before there was one waits for it. */
let started: Promise<unknown> = new Promise((resolve) => (onFirstStart = resolve))
/** After so many milliseconds a part that could not be loaded is asked for again. */
const RETRY = 5000

/** A trap leaves the module's memory in an unknown state: say so, and let the page start a new worker. */
function crash(error: unknown): void {
  port?.postMessage({ type: 'crash', message: causeOf(error) })
}

/** What the core says; a part of it that is needed for that is loaded first, and the words for it. */
async function answer<T>(ask: () => T): Promise<Answer<T>> {
  try {
    return { ok: true, value: await (await rest()).ready(ask) }
  } catch (error) {
    const dead = error instanceof ModuleDead
    if (dead) crash(error)
    return { ok: false, refusal: refusalOf(error) ?? { message: causeOf(error), field: '', unloaded: !dead } }
  }
}

/** The same of what has words only when it is refused: they are loaded then. */
async function silently<T>(ask: () => T): Promise<Answer<T>> {
  try {
    return { ok: true, value: ask() }
  } catch {
    return answer(ask)
  }
}

/** Asks the session something between two steps, after a start that is on its way. */
async function betweenSteps<T>(ask: (session: Session) => T): Promise<Answer<T>> {
  await started
  for (;;) {
    // Between the look at the step and the question nothing else may happen: what they need is loaded before, by `ready`.
    const found = await answer(() => (current().partly ? null : { value: ask(current()) }))
    if (!found.ok) return found
    if (found.value) return { ok: true, value: found.value.value }
    await running().untilStepEnds()
  }
}

function running(): Simulation {
  if (!simulation) throw new Error('the core is not loaded yet')
  return simulation
}

const api = {
  /** `hands`: how many threads may work side by side; `core`: its first part, if it is compiled already. */
  async open(frames: MessagePort, hands: number, core?: WebAssembly.Module): Promise<void> {
    port = frames
    await begin(core)
    simulation = new Simulation(frames, crash, async () => {
      const { Crew } = await import('./subtasks')
      return new Crew(hands, thread, oneself)
    })
    frames.onmessage = ({ data }: MessageEvent<ReturnedBuffer>) => simulation?.giveBack(data.buffer)
  },
  /** It has received what was sent before. */
  ping: (): void => undefined,
  /** Of a thread that carries out runs for another one. */
  async carryOut(errand: Errand): Promise<Finding> {
    return (await rest()).ready(() => carryOut(errand))
  },
  /** `request`: the page's number of this request, which pictures carry back. */
  start(setup: UncheckedSetup, opening: Opening, request: number): Promise<Answer<Run>> {
    const answered = silently(() => running().start(setup, opening, request))
    onFirstStart(answered)
    started = answered
    return answered
  },
  /** The first picture is seen: what it did not need may come. */
  async drawn(): Promise<void> {
    try {
      await (await rest()).load('links')
    } catch {
      setTimeout(() => void api.drawn(), RETRY)
      return
    }
    running().tellLinks()
  },
  // Before it is open there is no run that these could hold for: the page starts one where it wants it.
  play: (request: number): void => simulation?.play(request),
  pause: (request: number): void => simulation?.pause(request),
  speed: (speed: Speed): void => simulation?.setSpeed(speed),
  seek: (iteration: number, play: boolean, request: number): void => simulation?.seek(iteration, play, request),
  /** `request`: the page's number of this request. */
  async watch(item: Item | null, request: number): Promise<void> {
    await words()
    await started
    simulation?.watch(item, request)
  },
  look: (look: Viewport): void => simulation?.look(look),
  /** Tells the members' numbers with the pictures, at most so often (in milliseconds); null: not at all. */
  tellMembers: (interval: number | null): void => simulation?.tellMembers(interval),
  inspect: (item: Item): Promise<Answer<Inspection | null>> => betweenSteps((session) => session.inspect(item)),
  drive: (params: Record<string, ParameterValue>): Promise<Answer<Followed<Drive>>> =>
    betweenSteps(() => running().follow((session) => session.drive(params))),
  motion: (params: Record<string, ParameterValue>): Promise<Answer<Followed<Motion>>> =>
    betweenSteps(() => running().follow((session) => session.motion(params))),
  /** The postures that bring the tip to a point. */
  armSolutions: (scene: Scene, point: Point3, direction: Point3 | null, near?: number[]): Promise<Answer<ArmSolutions>> =>
    answer(() => armSolutions(scene, point, direction, near)),
  /** Where the tip can come: computed by another thread, so that this one goes on. Nothing if it was called off. */
  async reach(scene: Scene, step: number): Promise<Answer<Reachability> | null> {
    surveyor ??= new (await import('./reachability')).Surveyor()
    return surveyor.ask(scene, step)
  },
  callOff: (): void => surveyor?.callOff(),
  /** Of that other thread. */
  async survey(scene: Scene, step: number): Promise<Answer<Reachability>> {
    return answer(() => reachability(scene, step))
  },
  async pick(x: number, y: number, reach: number): Promise<Item | null> {
    const picked = await betweenSteps((session) => session.pick(x, y, reach))
    return picked.ok ? picked.value : null
  },
  importScene: (files: NamedFile[], problem?: number): Promise<Answer<Imported>> => answer(() => importScene(files, problem)),
  exportScene: (scene: Scene, format: Format): Promise<Answer<NamedFile[]>> => answer(() => exportScene(scene, format)),
  generateScene: (name: string, params: Record<string, ParameterValue>, seed: number): Promise<Answer<Scene>> =>
    answer(() => generateScene(name as GeneratorName, params, seed)),
  suggest: (setup: UncheckedSetup): Promise<Answer<Suggestion | null>> => silently(() => suggest(setup as Setup)),
  parseLink: (link: string): Promise<Answer<LinkSetup>> => answer(() => parseLink(link)),
  newSeed: (): number => newSeed(),
  outcome: (): Promise<Answer<Outcome>> => betweenSteps((session) => session.outcome()),
  svg: (dark: boolean, layers: string[]): Promise<Answer<string>> => betweenSteps((session) => session.svg(dark, layers as LayerName[])),
  link: (): Promise<Answer<string>> => betweenSteps((session) => session.link()),
  csv: (): Promise<Answer<string>> => betweenSteps((session) => session.csv()),
  tourFile: (): Promise<Answer<NamedFile | null>> => betweenSteps((session) => session.tourFile()),
  async field(request: FieldRequest): Promise<ImageBitmap | null> {
    await breathe()
    return painted(request, current)
  },
  /** A function that is not that of the run. */
  async preview(request: FieldRequest, planner: string): Promise<ImageBitmap | null> {
    await breathe()
    let session: Session | undefined
    const picture = await painted(
      request,
      () => (session = new Session({ planner: planner as PlannerName, scene: request.scene, seed: 0 })),
    )
    session?.free()
    return picture
  },
}

async function painted({ min, max, width, height, ramp }: FieldRequest, session: () => Session): Promise<ImageBitmap | null> {
  const canvas = new OffscreenCanvas(width, height)
  const context = canvas.getContext('2d')
  const done = await silently(() => context !== null && session().paintField(context, min, max, ramp))
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
