import { armPose, Session, shapes } from 'forage-lab'
import type { Setup, UncheckedSetup } from 'forage-lab'
import { extent } from './extent'
import { fieldsOf } from './fields'
import { breathe, SLICE, step } from './pace'
import { pack } from './pack'
import { Buffers } from './buffers'
import type { Viewport } from '../../render/frame'
import type { Picture, Settled, Start } from '../race.protocol'

/** Vertices a layer may have: several canvases are drawn at once. */
const BUDGET = 40_000
/** So many first steps say how much a step evaluates. */
const PROBES = 3
/** The number of the shape that is a field. */
const FIELD = shapes.indexOf('field')
const REPORT_INTERVAL = 150
/** At most this share of the time goes into outcomes. */
const REPORT_SHARE = 10

/** A run whose clock is its evaluations: it is taken to the first iteration at or beyond so many of them. */
export class Racer {
  session: Session | undefined
  /** How many iterations it has come at its furthest. */
  private furthest = 0
  private readonly pool = new Buffers(3)
  /** Iterations in which something was evaluated, and how much there was then. */
  private marks: { iteration: number; evaluations: number }[] = []
  private most = 0
  private ended = false
  private looked: Viewport = { fields: [], window: null }
  /** Grows with each command that makes the one before pointless. */
  private token = 0
  private underway = false
  private toldCurve = -1
  private lastReport = 0
  private reportCost = 0

  start(setup: UncheckedSetup): Start {
    const session = new Session(setup as Setup)
    this.token += 1
    this.session?.free()
    Object.assign(this, { session, furthest: 0, ended: false, underway: false, toldCurve: -1, lastReport: 0 })
    this.marks = [{ iteration: 0, evaluations: session.evaluations }]
    this.most = probe(session)
    // From here on the feasible best is kept.
    session.curve()
    this.lookAt()
    const { planner, scene, seed, parameters, evaluations: first } = session
    const skeleton =
      scene.kind === 'arm'
        ? armPose(
            scene,
            scene.arm.joints.map(({ home }) => home),
          ).skeleton
        : []
    return { planner, scene, seed, parameters, exact: session.exact(), first, most: this.most, limit: extent(session, 0), skeleton }
  }

  /** Goes to the first iteration at or beyond so many evaluations, or to the end; nothing if a newer command has come. */
  async go(clock: number): Promise<Picture | null> {
    this.token += 1
    const { session, token } = this
    if (!session) return null
    this.underway = true
    const known = this.iterationAt(clock)
    // Where it never was it goes on from within the step that it has begun.
    const reached = (known === null && session.iteration === this.furthest) || (await this.reach(session, known ?? this.furthest, token))
    if (!reached || (known === null && !(await this.discover(session, clock, token)))) return null
    this.underway = false
    return this.picture()
  }

  /** Leaves off, wherever it is: what was found on the way stays known. */
  halt(): void {
    this.token += 1
  }

  /** As far as it is known: where the run was at a clock's time. */
  private iterationAt(clock: number): number | null {
    let [low, high] = [0, this.marks.length]
    while (low < high) {
      const middle = (low + high) >> 1
      if ((this.marks[middle]?.evaluations ?? 0) < clock) low = middle + 1
      else high = middle
    }
    return this.marks[low]?.iteration ?? (this.ended ? this.furthest : null)
  }

  /** Goes where it was before; true if it came there. */
  private async reach(session: Session, iteration: number, token: number): Promise<boolean> {
    if (session.iteration === iteration && !session.partly) return true
    session.rewind(iteration)
    let until = performance.now() + SLICE
    while (session.iteration < iteration && session.status === 'running') {
      if (!(await step(session, () => token === this.token))) return false
      if (performance.now() < until) continue
      await breathe()
      if (token !== this.token) return false
      until = performance.now() + SLICE
    }
    return true
  }

  /** Goes where it never was, and keeps what each step evaluated. */
  private async discover(session: Session, clock: number, token: number): Promise<boolean> {
    let until = performance.now() + SLICE
    while (session.partly || (session.status === 'running' && session.evaluations < clock)) {
      const before = this.marks.at(-1)?.evaluations ?? 0
      if (!(await step(session, () => token === this.token))) return false
      const { iteration, evaluations } = session
      this.furthest = iteration
      if (evaluations > before) this.marks.push({ iteration, evaluations })
      this.most = Math.max(this.most, evaluations - before)
      if (performance.now() < until) continue
      await breathe()
      if (token !== this.token) return false
      until = performance.now() + SLICE
    }
    this.ended = session.status !== 'running'
    return true
  }

  /** What is looked at from now on, and how it is seen; nothing while it is on its way. */
  look(look: Viewport): Picture | null {
    this.looked = look
    this.lookAt()
    return this.session && !this.underway ? this.picture() : null
  }

  private lookAt(): void {
    const { window } = this.looked
    this.session?.lookAt(window?.min, window?.max)
  }

  settle(): Settled | null {
    const { session } = this
    return session && !this.underway
      ? { iteration: session.iteration, outcome: session.outcome(), hash: session.hash(), link: session.link() }
      : null
  }

  giveBack(buffer: ArrayBuffer): void {
    this.pool.giveBack(buffer)
  }

  private picture(): Picture | null {
    const { session, most, ended } = this
    if (!session) return null
    const outcome = this.outcome(session)
    const known = session.curve()
    const curve = known.values.length === this.toldCurve ? null : known
    this.toldCurve = known.values.length
    const { iteration, evaluations, status } = session
    const last = this.marks.at(-1) ?? { iteration: 0, evaluations: 0 }
    const furthest = {
      iteration: this.furthest,
      evaluations: last.evaluations,
      limit: extent(session, this.furthest),
      most,
      ended,
      tail: ended && last.iteration < this.furthest,
    }
    // The views last until the next call: nothing of the core may come between here and the copy.
    const { vertices, spans, thinning } = session.frame(BUDGET)
    const packed = pack(vertices, spans, FIELD, (bytes) => this.pool.take(bytes))
    const fields = fieldsOf(session, this.looked.fields)
    return { iteration, evaluations, status, furthest, ...packed, fields, thinning, curve, outcome }
  }

  private outcome(session: Session): Picture['outcome'] {
    const now = performance.now()
    if (now - this.lastReport < Math.max(REPORT_INTERVAL, this.reportCost * REPORT_SHARE)) return null
    const outcome = session.outcome()
    this.lastReport = performance.now()
    this.reportCost = this.lastReport - now
    return outcome
  }
}

/** The most evaluations of one of the first steps. A step that is long or needs runs of other planners is not taken for that. */
function probe(session: Session): number {
  let most = 0
  for (let step = 0; step < PROBES && session.jobs().length === 0; step += 1) {
    const before = session.evaluations
    const partly = session.advance() === 'partly'
    most = Math.max(most, session.evaluations - before)
    if (partly) break
  }
  session.rewind(0)
  return most
}
