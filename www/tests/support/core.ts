import {
  catalogue,
  type Outcome,
  parseLink,
  type Scene,
  Session,
  type Setup,
  Trial,
  type TrialRecord,
  type UncheckedSetup,
} from '../../../pkg/node.js'
import { iterationsFor } from '../../src/engine/budget'

/* The same core under Node: what the page must agree with to the bit. */

const DISCS: UncheckedSetup = { planner: 'wcpso', scene: 'wcpso-discs', seed: 1 }

/** What `ask` learns of the run at an iteration. */
export function sessionAt<T>(setup: Partial<UncheckedSetup>, iteration: number, ask: (session: Session) => T): T {
  const session = new Session({ ...DISCS, ...setup } as Setup)
  session.seek(iteration)
  const answer = ask(session)
  session.free()
  return answer
}

export const hashOf = (setup: Partial<UncheckedSetup>, iteration: number): string =>
  sessionAt(setup, iteration, (session) => session.hash())

export const linkTo = (setup: Partial<UncheckedSetup>, iteration: number): string =>
  sessionAt(setup, iteration, (session) => session.link())

export const outcomeOf = (setup: Partial<UncheckedSetup>, iteration: number): Outcome =>
  sessionAt(setup, iteration, (session) => session.outcome())

export const sceneOf = (setup: Partial<UncheckedSetup>): Scene => sessionAt(setup, 0, (session) => session.scene)

/** What a run comes to in the end, and the best values on its way. */
export function trialOf(setup: UncheckedSetup): { record: TrialRecord; curve: { evaluations: number[]; values: number[] }; link: string } {
  const trial = new Trial(setup as Setup, undefined)
  trial.step()
  const { evaluations, values } = trial.curve()
  const told = { record: trial.record(), curve: { evaluations: [...evaluations], values: [...values] }, link: trial.link() }
  trial.free()
  return told
}

/** The number of a layer in the session's frames. Ask before the frame: its views hold until the next call. */
export const layerOf = ({ planner }: Session, key: string): number =>
  catalogue()
    .planners.find(({ name }) => name === planner)
    ?.layers.findIndex(({ role }) => role === key) ?? -1

/** Where the particles are on a function's map. */
export const particles = (setup: Partial<UncheckedSetup>, iteration: number): [number, number][] =>
  sessionAt(setup, iteration, (session) => {
    const role = layerOf(session, 'particles')
    const { vertices, spans } = session.frame(1e6)
    const found: [number, number][] = []
    for (let span = 0; span < spans.length; span += 4) {
      const [of = -1, , first = 0, count = 0] = spans.subarray(span, span + 4)
      if (of !== role) continue
      for (let at = 4 * first; at < 4 * (first + count); at += 4) found.push([vertices[at] ?? NaN, vertices[at + 1] ?? NaN])
    }
    return found
  })

/** Bends of the particles' paths, ends left out. */
export const bends = (setup: Partial<UncheckedSetup>, iteration: number): [number, number][] =>
  sessionAt(setup, iteration, (session) => {
    const role = layerOf(session, 'particles')
    const { vertices, spans } = session.frame(1e6)
    const found: [number, number][] = []
    for (let span = 0; span < spans.length; span += 4) {
      const [of = -1, , first = 0, count = 0] = spans.subarray(span, span + 4)
      if (of !== role) continue
      for (let at = 4 * (first + 1); at < 4 * (first + count - 1); at += 4) found.push([vertices[at] ?? NaN, vertices[at + 1] ?? NaN])
    }
    return found
  })

/** What a link of the page says, and that the core agrees with the hash in it. */
export function verified(link: string): ReturnType<typeof parseLink> {
  const setup = parseLink(link)
  const { planner, scene, params, seed, iteration } = setup
  const hash = hashOf({ planner, scene, params, seed }, iteration)
  if (hash !== setup.hash) throw new Error(`the link promises ${setup.hash}, the core comes to ${hash}`)
  return setup
}

/** The iterations that a planner gets for so many evaluations. */
export function iterationsOf(setup: Partial<UncheckedSetup>, evaluations: number): number {
  const [first, limit] = sessionAt(setup, 0, (session) => [session.evaluations, session.limit])
  let idle = 0
  let step = 0
  for (; step === 0; idle += 1) step = sessionAt(setup, idle + 1, (session) => session.evaluations) - first
  return iterationsFor({ start: first, idle: idle - 1, step, limit }, evaluations, 1e6)
}
