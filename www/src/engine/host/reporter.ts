import type { CodeInLinks } from './setups'
import { type Session, shapes } from 'forage-lab/core'
import type { RunEvent, TrialCurve } from 'forage-lab'
import type { Desired, Picture, Report, Run, Span } from '../protocol'
import type { Buffers } from './buffers'
import { spanOf } from './extent'
import { fieldsOf } from './fields'
import { pack } from './pack'

/** The number of the shape that is a field. */
const FIELD = shapes.indexOf('field')
/** The whole state's summary costs more than a picture: while playing it is reported a few times a second. */
const OUTCOME_INTERVAL = 250
/** At most this share of the time goes into outcomes. */
const OUTCOME_SHARE = 20

/** What costs more than a picture. */
type Rare = Pick<Report, 'outcome' | 'link' | 'hash'>

/** Assembles the reports of one run: of what only grows each brings what is new. */
export class Reporter {
  /** The run's description, until it was reported. */
  private fresh: Run | null
  private span: Span
  private traced = -1
  /** How many events were reported, and up to which iteration they are all that there are. */
  private known = { events: 0, until: -1 }
  private curve = -1
  private repeats = false
  private lastOutcome = 0
  private outcomeCost = 0
  private lastMembers = Number.NEGATIVE_INFINITY
  /** Of the state in which it is settled. */
  private settled: { rare: Rare; iteration: number } | null = null

  constructor(
    private readonly session: Session,
    private readonly buffers: Buffers,
    readonly run: Run,
    private readonly codeInLinks: CodeInLinks,
  ) {
    this.fresh = run
    this.span = run.span
  }

  /** Whether there is a buffer for another picture. */
  get ready(): boolean {
    return this.buffers.ready
  }

  /** Links can be made from now on. */
  forgetSettled(): void {
    this.settled = null
  }

  /** All that was said is said once more. */
  repeat(): void {
    this.settled = null
    this.repeats = true
  }

  /** The members' numbers come with the next report. */
  askMembers(): void {
    this.lastMembers = Number.NEGATIVE_INFINITY
  }

  report(desired: Desired, state: Pick<Report, 'version' | 'playing' | 'arrived' | 'furthest'>): Report {
    const { session } = this
    const rare = this.rare(state.arrived && desired.summary, desired.links)
    const readings = session.readings()
    const trace = session.trace(this.traced)
    this.traced = trace.iterations.at(-1) ?? this.traced
    const events = this.repeats ? this.session.events(0) : this.events()
    const span = this.newSpan(state.furthest.iteration) ?? (this.repeats ? this.span : null)
    const inspection = desired.item ? session.inspect(desired.item) : null
    const { item, supposition } = desired
    const known = inspection?.suppositions.some(({ name }) => name === supposition?.name)
    const supposed = item && supposition && known ? session.suppose(item, supposition.name, supposition.draw) : null
    const members = this.members(desired.members, state.arrived)
    const curve = desired.clock === 'evaluations' ? this.newCurve() : null
    const { evaluations, status } = session
    const { thinning, ...picture } = this.draw(desired)
    const { repeats } = this
    this.repeats = false
    const { fresh } = this
    this.fresh = null
    return {
      is: 'report',
      ...state,
      ...picture,
      run: fresh,
      evaluations,
      status,
      readings,
      thinning,
      ranges: Object.fromEntries(picture.frame.fields.map(({ role, range }) => [role, range])),
      trace,
      events,
      repeats,
      span,
      inspection,
      supposed,
      members,
      curve,
      ...rare,
    }
  }

  /** The picture alone. */
  picture(desired: Desired): Picture {
    const { thinning: _, ...picture } = this.draw(desired)
    return picture
  }

  private draw({ budget, viewport }: Desired): Picture & { thinning: number } {
    const { session, run } = this
    const { iteration } = session
    // The views last until the next call: nothing of the core may come between here and the copy.
    const { vertices, spans, thinning } = session.frame(budget)
    const packed = pack(vertices, spans, FIELD, (bytes) => this.buffers.take(bytes))
    const fields = fieldsOf(session, viewport.fields)
    return { generation: run.generation, planner: run.planner, iteration, thinning, frame: { ...packed, fields } }
  }

  /** What travels with a picture instead of being copied. */
  static transfers({ frame, members = null }: Picture & { members?: Float64Array | null }): Transferable[] {
    return [frame.buffer, ...(members ? [members.buffer as ArrayBuffer] : []), ...frame.fields.map(({ bitmap }) => bitmap)]
  }

  /** A run always happens in the same way: what was reported once still holds after a step back. */
  private events(): RunEvent[] {
    const { session, known } = this
    if (session.iteration <= known.until) return []
    const fresh = session.events(known.events)
    this.known = { events: known.events + fresh.length, until: session.iteration }
    return fresh
  }

  private newSpan(furthest: number): Span | null {
    const { extent, end } = this.span
    const span = spanOf(this.session, furthest)
    if (span.extent === extent && (span.end === null) === (end === null)) return null
    this.span = span
    return span
  }

  private members(interval: number | null, settled: boolean): Float64Array | null {
    if (interval === null) return null
    const now = performance.now()
    if (!settled && now - this.lastMembers < interval) return null
    this.lastMembers = now
    return this.session.members()
  }

  private newCurve(): TrialCurve | null {
    const curve = this.session.curve()
    if (curve.values.length === this.curve) return null
    this.curve = curve.values.length
    return curve
  }

  private rare(settled: boolean, links: boolean): Rare {
    const { session } = this
    const now = performance.now()
    if (settled && this.settled?.iteration === session.iteration) return this.settled.rare
    if (!settled && now - this.lastOutcome < Math.max(OUTCOME_INTERVAL, this.outcomeCost * OUTCOME_SHARE))
      return { outcome: null, link: null, hash: null }
    const rare = {
      outcome: session.outcome(),
      link: links && this.codeInLinks.ok ? session.link() + this.codeInLinks.value : null,
      hash: settled ? session.hash() : null,
    }
    this.lastOutcome = performance.now()
    this.outcomeCost = this.lastOutcome - now
    this.settled = settled ? { rare, iteration: session.iteration } : null
    return rare
  }
}
