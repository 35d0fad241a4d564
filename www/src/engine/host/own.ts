/* Planners that somebody wrote: a thread that runs one makes it known to its core first. Loaded when there is one. */
import { codeIn, registerCode, stateOf, withCode } from 'forage-lab/isolate'
import type { Planner, Session } from 'forage-lab'
import type { Line } from '../protocol'
import { registerPlain } from './plain'
import { printing } from './printing'

/** A code that is known to this thread's core. */
interface Known {
  code: string
  full: boolean
  described: Planner
  lines: Line[]
}

/** What there was before and after a step. */
export interface States {
  iteration: number
  /** Undefined at the beginning. */
  before: unknown
  now: unknown
}

const known = new Map<string, Known>()
/** One after the other: the newest of a name is the one that runs. */
let queue: Promise<unknown> = Promise.resolve()
/** How many lines are kept. */
const LINES = 200

// What is done again is printed again.
printing.onstep = (iteration) => {
  for (const one of known.values()) one.lines = one.lines.filter((line) => line.iteration < iteration)
}

async function read(code: string, full?: boolean): Promise<Known> {
  const last = [...known.values()].find((one) => one.code === code && (full === undefined || one.full === full))
  if (last) return last
  let lines: Line[] = []
  let found: Known | undefined
  const onprint = (text: string): void => {
    if (printing.muted) return
    const line = { iteration: printing.iteration, text }
    if (found) found.lines = [...found.lines, line].slice(-LINES)
    else lines = [...lines, { ...line, iteration: -1 }].slice(-LINES)
  }
  const described = full ? await registerPlain(code, onprint) : await registerCode(code, { onprint })
  found = { code, full: full === true, described, lines }
  known.set(described.name, found)
  return found
}

/** Makes a code's planner known: with or without an interpreter, or as it is known already. Fails with what is wrong in it. */
export function loadPlanner(code: string, full?: boolean): Promise<Known> {
  const found = queue.then(() => read(code, full))
  queue = found.catch(() => undefined)
  return found
}

export { codeIn, withCode }

/** The lines that a session's planner has printed. */
export const linesOf = ({ planner }: Session): Line[] => known.get(planner)?.lines ?? []

/** The state of a session's planner after its last step, and before; null where nobody wrote it. */
export function statesOf(session: Session): States | null {
  const { iteration } = session
  const now = stateOf(session)
  if (now === undefined) return null
  if (iteration === 0) return { iteration, before: undefined, now }
  printing.muted = true
  try {
    session.seek(iteration - 1)
    return { iteration, before: stateOf(session), now }
  } finally {
    session.seek(iteration)
    printing.muted = false
  }
}
