import type { RunSetup } from '../../catalogue/own'
import { armSolutions, exportScene, generateScene, importScene, newSeed, parseLink, Session, suggest } from 'forage-lab/core'
import type {
  ArmSolutions,
  Drive,
  Format,
  FrameViews,
  GeneratorName,
  Imported,
  Inspection,
  Item,
  LinkSetup,
  Motion,
  NamedFile,
  Outcome,
  Planner,
  ParameterValue,
  PlannerName,
  Point3,
  Scene,
  Suggestion,
} from 'forage-lab'
import type { FieldRequest, HeightMap } from '../../render/frame'
import type { Answer, Line } from '../protocol'
import { answer, silently, within } from './answers'
import { breathe } from './pace'
import type { States } from './own'
import type { RunHost } from './run-host'
import { rest } from './rest'
import { registered } from './setups'

type Values = Record<string, ParameterValue>

/** What follows a result, and the state of the run that it is of. */
export interface Followed<T> {
  result: T | null
  generation: number
  iteration: number
}

/** What a host can be asked. What is asked of a run waits until there is the run that is wanted, between two of its steps. */
export function questionsTo(host: RunHost) {
  const ofRun = async <T>(ask: (session: Session) => T): Promise<Answer<T>> => {
    await host.spoken
    for (;;) {
      if (!(await host.untilStepEnds())) return { ok: false, refusal: { message: 'there is no run', field: '' } }
      const { session } = host
      // Between the look at the step and the question nothing else may happen: what they need is loaded before, by `ready`.
      const found = await answer(() => (!session || session.partly || session !== host.session ? null : { value: ask(session) }))
      if (!found.ok) return found
      if (found.value) return { ok: true, value: found.value.value }
    }
  }
  const follow = <T>(by: (session: Session) => T | null): Promise<Answer<Followed<T>>> =>
    ofRun((session) => ({ result: by(session), generation: host.generation, iteration: session.iteration }))

  return {
    inspect: (item: Item): Promise<Answer<Inspection | null>> => ofRun((session) => session.inspect(item)),
    drive: (params: Values): Promise<Answer<Followed<Drive>>> => follow((session) => session.drive(params)),
    motion: (params: Values): Promise<Answer<Followed<Motion>>> => follow((session) => session.motion(params)),
    async pick(x: number, y: number, reach: number): Promise<Item | null> {
      const picked = await ofRun((session) => session.pick(x, y, reach))
      return picked.ok ? picked.value : null
    },
    /** The vertices of a layer of the frame, piece by piece. */
    pieces: (layer: number): Promise<Answer<Followed<Float32Array[]>>> => follow((session) => piecesOf(session.frame(host.budget), layer)),
    outcome: (): Promise<Answer<Outcome>> => ofRun((session) => session.outcome()),
    async link(): Promise<Answer<string>> {
      const link = await ofRun((session) => host.linkOf(session))
      return link.ok ? link.value : link
    },
    /** What a planner is whose code this is, and the code as links have it; null where it is too long for one. */
    async read(code: string): Promise<Answer<{ planner: Planner; packed: string | null }>> {
      const own = await import('./own')
      const link = await within(() => own.withCode('', code))
      return within(async () => ({ planner: (await own.loadPlanner(code)).described, packed: link.ok ? link.value : null }))
    },
    /** The code in a link; null where it has none. */
    async codeIn(link: string): Promise<Answer<string | null>> {
      const own = await import('./own')
      return within(async () => (await own.codeIn(link)) ?? null)
    },
    /** What the run's planner has printed. */
    lines: async (): Promise<Line[]> => (host.session ? (await import('./own')).linesOf(host.session) : []),
    /** The state of the run's planner now and one iteration before; null where nobody wrote it. */
    async states(): Promise<Answer<States | null>> {
      const own = await import('./own')
      return ofRun(own.statesOf)
    },
    csv: (): Promise<Answer<string>> => ofRun((session) => session.csv()),
    tourFile: (): Promise<Answer<NamedFile | null>> => ofRun((session) => session.tourFile()),
    /** The heights of the run's function. */
    async field(request: FieldRequest): Promise<HeightMap | null> {
      await breathe()
      return painted(request, host.session)
    },
    /** Those of another function; refused where it is none. */
    async preview(request: FieldRequest, planner: string): Promise<Answer<HeightMap | null>> {
      await breathe()
      const made = await silently(() => new Session({ planner: planner as PlannerName, scene: request.scene, seed: 0 }))
      if (!made.ok) return made
      const value = await painted(request, made.value)
      made.value.free()
      return { ok: true, value }
    },
    /** The postures that bring the tip to a point. */
    armSolutions: (scene: Scene, point: Point3, direction: Point3 | null, near?: number[]): Promise<Answer<ArmSolutions>> =>
      answer(() => armSolutions(scene, point, direction, near)),
    importScene: (files: NamedFile[], problem?: number): Promise<Answer<Imported>> => answer(() => importScene(files, problem)),
    exportScene: (scene: Scene, format: Format): Promise<Answer<NamedFile[]>> => answer(() => exportScene(scene, format)),
    generateScene: (name: string, params: Values, seed: number): Promise<Answer<Scene>> =>
      answer(() => generateScene(name as GeneratorName, params, seed)),
    async suggest(setup: RunSetup): Promise<Answer<Suggestion | null>> {
      const plain = await registered(setup)
      return plain.ok ? silently(() => suggest(plain.value)) : plain
    },
    /** `code`: of the link's planner, if it is nobody else's. */
    async parseLink(link: string, code?: string): Promise<Answer<LinkSetup>> {
      const known = await within(async () => code !== undefined && (await import('./own')).loadPlanner(code))
      if (!known.ok) return known
      // What reads links needs no words, unless it refuses one.
      await (await rest()).loadCode('links').catch(() => undefined)
      return silently(() => parseLink(link))
    },
    newSeed: async (): Promise<number> => newSeed(),
  }
}

export type Questions = ReturnType<typeof questionsTo>

/** Copies them: the views of a frame last until the next call of the core. */
function piecesOf({ vertices, spans }: FrameViews, layer: number): Float32Array[] {
  const pieces: Float32Array[] = []
  for (let at = 0; at < spans.length; at += 4) {
    const [of, , first = 0, count = 0] = spans.subarray(at, at + 4)
    if (of === layer) pieces.push(vertices.slice(4 * first, 4 * (first + count)))
  }
  return pieces
}

async function painted({ min, max, width, height, ramp }: FieldRequest, session: Session | undefined): Promise<HeightMap | null> {
  const canvas = new OffscreenCanvas(width, height)
  const context = canvas.getContext('2d')
  const done = await silently(() => context !== null && (session?.paintField(context, min, max, ramp) ?? false))
  return done.ok && done.value && session ? { bitmap: canvas.transferToImageBitmap(), heights: [...(session.heights ?? [])] } : null
}
