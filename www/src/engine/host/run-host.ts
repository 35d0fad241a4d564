import { Session, shapes } from 'forage-lab/core'
import type { Item, RunEvent, Setup, UncheckedSetup } from 'forage-lab'
import type { Crew, Task } from './subtasks'
import { spanOf } from './extent'
import { fieldsOf } from './fields'
import { breathe, SLICE, step, wait } from './pace'
import { pack } from './pack'
import { Pool } from './buffers'
import { words } from './rest'
import type { Viewport } from '../../render/frame'
import type { Followed, FrameMessage, Opening, ProgressMessage, Report, Run, Span, Speed } from '../protocol'

/** Vertices a layer may have: what a canvas draws in a few tens of milliseconds. */
const BUDGET = 100_000
/** The number of the shape that is a field. */
const FIELD = shapes.indexOf('field')
const FRAME_INTERVAL = 1000 / 60
/** The whole state's summary costs more than a picture: while playing it is told a few times a second. */
const REPORT_INTERVAL = 250
/** A step that takes longer than this is reported as long, in milliseconds. */
const LONG = 400
/** How often the progress of a step is told. */
const PROGRESS_INTERVAL = 100
/** At most this share of the time goes into reports. */
const REPORT_SHARE = 20

/** Owns the session and the loop that steps it; sends a picture whenever the page has returned a buffer. */
export class Simulation {
  session: Session | undefined
  private readonly pool = new Pool(3)
  private generation = 0
  private computed = 0
  private traced = -1
  /** How many events the page knows, and up to which iteration they are all that there are. */
  private heard = { events: 0, until: -1 }
  /** The end of the run, as it was told. */
  private extent = 0
  private open = false
  /** Those who carry out runs that steps need; most planners need none. */
  private crew: Crew | undefined
  private task: Task | undefined
  private playing = false
  /** It is on its way to an iteration, whatever the pace. */
  private reaching = false
  /** The page's number of the newest start, seek, play or pause. */
  private request = 0
  /** Where the newest of these wanted the run, and the number of the newest seek. */
  private wanted = { at: 0, play: false, sought: 0 }
  /** The number of the request that started the run. */
  private startedBy = 0
  private pace: Speed = 30
  private watched: Item | null = null
  private looked: Viewport = { fields: [], window: null }
  /** Grows with each command that makes a running loop pointless. */
  private token = 0
  private stale = false
  private lastFrame = 0
  private lastReport = 0
  private lastProgress = 0
  /** The page has been told that a step takes long. */
  private waits = false
  private reportCost = 0
  /** How often the members' numbers are told. */
  private membersInterval: number | null = null
  private lastMembers = 0
  private settled = false
  /** The core can make links. */
  private linked = false
  /** What was told of the state in which it stands still. */
  private told: Report | null = null

  constructor(
    private readonly port: MessagePort,
    private readonly crash: (error: unknown) => void,
    private readonly hire: () => Promise<Crew>,
  ) {}

  /**
   * Starts a run, or throws before anything has changed. A seek, play or pause that was requested after the start counts more than
   * `opening`: it may have come first, while a part was loaded.
   */
  start(setup: UncheckedSetup, opening: Opening, request: number): Run {
    const session = new Session(setup as Setup)
    const { wanted } = this
    const at = wanted.sought > request ? wanted.at : opening.at
    const play = this.request > request ? wanted.play : opening.play
    this.startedBy = request
    this.token += 1
    this.session?.free()
    this.session = session
    this.lookAt()
    this.generation += 1
    this.computed = 0
    this.traced = -1
    this.heard = { events: 0, until: -1 }
    this.watched = null
    const { planner, scene, seed, limit, parameters } = session
    const span = spanOf(session, 0)
    this.extent = span.extent
    this.open = span.end === null
    const exact = session.exact()
    this.task = { planner, scene }
    this.crew?.begin(this.task)
    this.stale = true
    this.go(at, play)
    this.request = Math.max(this.request, request)
    return { generation: this.generation, planner, scene, seed, limit, span, parameters, exact }
  }

  play(request: number): void {
    this.note(request, true)
    if (this.playing || !this.session) return
    this.playing = true
    this.loop(async (token) => {
      if (this.session && this.session.status !== 'running') await this.reach(0, token)
      await this.run(token)
    })
  }

  pause(request = this.request): void {
    this.note(request, false)
    this.playing = false
    this.loop((token) => this.settle(token))
  }

  setSpeed(speed: Speed): void {
    this.pace = speed
    if (this.playing && !this.reaching) this.loop((token) => this.run(token))
  }

  /** Goes to an iteration and stands still there or plays on; a newer command overtakes it. */
  seek(iteration: number, play: boolean, request: number): void {
    this.note(request, play)
    this.wanted = { at: iteration, play, sought: request }
    this.go(iteration, play)
  }

  private note(request: number, play: boolean): void {
    this.request = request
    this.wanted.play = play
  }

  private go(iteration: number, play: boolean): void {
    this.playing = play
    this.loop(async (token) => {
      await this.reach(iteration, token)
      if (play) await this.run(token)
    })
  }

  /** Waits until no step is half taken: only then there is something to say of the run. */
  async untilStepEnds(): Promise<void> {
    while (this.session?.partly) await breathe()
  }

  /** What has been found is followed, by the robot or the arm; the run stands still for it. */
  follow<T>(by: (session: Session) => T | null): Followed<T> {
    if (this.playing) this.pause()
    const { session, generation } = this
    return { told: session ? by(session) : null, generation, iteration: session?.iteration ?? 0 }
  }

  /** What was requested before the run was is of another one. */
  watch(item: Item | null, request: number): void {
    if (request < this.startedBy) return
    this.watched = item
    this.stale = true
    this.picture()
  }

  look(look: Viewport): void {
    this.looked = look
    this.lookAt()
    this.stale = true
    this.picture()
  }

  /** From now on links are told. */
  tellLinks(): void {
    if (this.linked) return
    this.linked = true
    this.told = null
    this.stale = true
    this.picture()
  }

  tellMembers(interval: number | null): void {
    this.membersInterval = interval
    this.lastMembers = 0
    this.stale = true
    this.picture()
  }

  private lookAt(): void {
    const { window } = this.looked
    this.session?.lookAt(window?.min, window?.max)
  }

  giveBack(buffer: ArrayBuffer): void {
    this.pool.giveBack(buffer)
    if (this.stale) this.guard(() => this.picture())
  }

  private loop(body: (token: number) => Promise<void>): void {
    this.token += 1
    this.crew?.drop()
    this.reaching = false
    this.settled = false
    this.told = null
    body(this.token).catch((error: unknown) => this.crash(error))
  }

  private guard(body: () => void): void {
    try {
      body()
    } catch (error) {
      this.crash(error)
    }
  }

  /** Takes a step, after the runs of other planners that it needs; false if a newer command has come meanwhile. */
  private async step(token: number): Promise<boolean> {
    const { session } = this
    if (!session) return false
    const jobs = session.jobs()
    if (jobs.length > 0) {
      this.crew ??= await this.hire().catch(() => undefined)
      if (token !== this.token || !this.task) return false
      const found = await this.crew?.carryOut(this.task, jobs, (done) => this.progress(done, jobs.length))
      if (token !== this.token) return false
      // Without it the step carries them out itself.
      if (found) session.supply(found)
    }
    // The step itself may take long as well: its own progress follows that of the runs.
    if (this.waits) this.tellProgress(0, 0)
    const long = performance.now() + LONG
    const over = await step(session, () => {
      if (token !== this.token) return false
      if (!this.waits && performance.now() > long) this.tellProgress(null, 1)
      return true
    })
    if (this.waits) this.tellProgress(0, 0)
    if (!over) return false
    this.computed = Math.max(this.computed, session.iteration)
    this.stale = true
    return true
  }

  private progress(done: number, total: number): void {
    // A wait begins: what there is must be seen.
    if (this.stale) this.guard(() => this.picture())
    const now = performance.now()
    if (now - this.lastProgress < PROGRESS_INTERVAL) return
    this.lastProgress = now
    this.tellProgress(done, total)
  }

  private tellProgress(done: number | null, total: number): void {
    this.waits = total > 0
    const message: ProgressMessage = {
      type: 'progress',
      generation: this.generation,
      step: (this.session?.iteration ?? 0) + 1,
      done,
      total,
    }
    this.port.postMessage(message)
  }

  private async reach(iteration: number, token: number): Promise<void> {
    const { session } = this
    if (!session) return
    this.reaching = true
    session.rewind(iteration)
    this.stale = true
    while (session.iteration < iteration && session.status === 'running') {
      const fresh = session.iteration >= this.computed
      await this.slice(iteration, token)
      if (token !== this.token) return
      if (fresh) this.showWhenDue()
      await breathe()
      if (token !== this.token) return
    }
    this.reaching = false
    await this.settle(token)
  }

  /** Steps up to an iteration for as long as a slice lasts. */
  private async slice(to: number, token: number): Promise<void> {
    const { session } = this
    const until = performance.now() + SLICE
    while (session && session.status === 'running' && session.iteration < to && performance.now() < until) {
      if (!(await this.step(token))) return
    }
  }

  private async run(token: number): Promise<void> {
    const { session } = this
    if (!session) return
    let due = performance.now()
    while (token === this.token && this.playing && session.status === 'running') {
      if (this.pace === Infinity) {
        await this.slice(Infinity, token)
      } else {
        const now = performance.now()
        // After a pause of the machine it goes on from here instead of catching up.
        if (now - due > 200) due = now
        while (due <= now && session.status === 'running') {
          if (!(await this.step(token))) return
          due += 1000 / this.pace
        }
      }
      if (token !== this.token) return
      this.showWhenDue()
      if (this.pace === Infinity) await breathe()
      else await wait(Math.max(0, due - performance.now()))
    }
    if (token === this.token) {
      this.playing = false
      await this.settle(token)
    }
  }

  /** Shows the state in which it stands still, whatever the pace. */
  private async settle(token: number): Promise<void> {
    await breathe()
    if (token !== this.token) return
    if (this.session?.partly && !(await this.step(token))) return
    // A run that has ended may say why: for that there must be words.
    if (this.session?.status !== 'running') await words()
    if (token !== this.token) return
    this.settled = !this.playing
    this.stale = true
    this.picture()
  }

  private showWhenDue(): void {
    const now = performance.now()
    if (now - this.lastFrame >= FRAME_INTERVAL - 1) this.picture()
  }

  private picture(): void {
    const { session } = this
    // A step that has begun is shown when it is over.
    if (!session || session.partly || !this.pool.ready) return
    this.stale = false
    this.lastFrame = performance.now()
    const report = this.report()
    const readings = session.readings()
    const trace = session.trace(this.traced)
    this.traced = trace.iterations.at(-1) ?? this.traced
    const events = this.events()
    const span = this.span()
    const inspection = this.watched ? session.inspect(this.watched) : null
    const members = this.members()
    const { iteration, status } = session
    // The views last until the next call: nothing of the core may come between here and the copy.
    const { vertices, spans, thinning } = session.frame(BUDGET)
    const packed = pack(vertices, spans, FIELD, (bytes) => this.pool.take(bytes))
    const fields = fieldsOf(session, this.looked.fields)
    const message: FrameMessage = {
      type: 'frame',
      generation: this.generation,
      planner: this.task?.planner ?? '',
      iteration,
      computed: this.computed,
      status,
      playing: this.playing,
      request: this.request,
      readings,
      thinning,
      ...packed,
      fields,
      trace,
      events,
      span,
      inspection,
      members,
      report,
    }
    const numbers = members ? [members.buffer] : []
    this.port.postMessage(message, [packed.buffer, ...numbers, ...fields.map(({ bitmap }) => bitmap)])
  }

  /** A run always happens in the same way: what was told once still holds after a step back. */
  private events(): RunEvent[] {
    const { session, heard } = this
    if (!session || session.iteration <= heard.until) return []
    const fresh = session.events(heard.events)
    this.heard = { events: heard.events + fresh.length, until: session.iteration }
    return fresh
  }

  /** What is new about the run's length. */
  private span(): Span | null {
    if (!this.session) return null
    const span = spanOf(this.session, this.computed)
    if (span.extent === this.extent && (span.end === null) === this.open) return null
    this.extent = span.extent
    this.open = span.end === null
    return span
  }

  private members(): Float64Array<ArrayBuffer> | null {
    const { session, settled, membersInterval: interval } = this
    if (!session || interval === null) return null
    const now = performance.now()
    if (!settled && now - this.lastMembers < interval) return null
    this.lastMembers = now
    return session.members() as Float64Array<ArrayBuffer>
  }

  private report(): Report | null {
    const { session, settled } = this
    if (settled && this.told) return this.told
    const now = performance.now()
    if (!session || (!settled && now - this.lastReport < Math.max(REPORT_INTERVAL, this.reportCost * REPORT_SHARE))) return null
    const report: Report = {
      outcome: session.outcome(),
      link: this.linked ? session.link() : null,
      settledHash: settled ? session.hash() : null,
    }
    this.lastReport = performance.now()
    this.reportCost = this.lastReport - now
    if (settled) this.told = report
    return report
  }
}
