import { armPose, Session, suggest } from 'forage-lab/core'
import type { ArmScene, Finding, Job } from 'forage-lab'
import { type Answer, DEFAULTS, type Desired, type FromHost, type Run, type Start, type Target } from '../protocol'
import { silently } from './answers'
import { Buffers } from './buffers'
import { spanOf } from './extent'
import { breathe, SLICE, step } from './pace'
import { stepping } from './printing'
import { Places } from './places'
import { Reporter } from './reporter'
import { type CodeInLinks, codeInLinks, registered } from './setups'
import { speakIn, words } from './rest'

const FRAME_INTERVAL = 1000 / 60
/** A run that plays faster than so many iterations a second is reported so often, in milliseconds: numbers that change faster cannot be read. */
const LEGIBLE = 30
const REPORT_INTERVAL = 200
/** A step that takes longer than this is reported as long, in milliseconds. */
const LONG = 400
/** After a pause of the machine that is longer than so many milliseconds a run goes on from there instead of catching up. */
const LATE = 200

const homeOf = ({ arm }: ArmScene): number[] => arm.joints.map(({ home }) => home)

/** The run that is there. */
interface Present {
  start: Start
  session: Session
  places: Places
  reporter: Reporter
  codeInLinks: CodeInLinks
}

/**
 * Hosts a run. It knows all that is wanted of it, and its only loop makes that true: it starts the run that is wanted, takes it
 * where it is wanted, and reports while it does. Changes are merged into what is wanted, so none is lost and none overtakes another.
 */
export class RunHost {
  private readonly desired: Desired = { ...DEFAULTS }
  private version = 0
  /** Of the newest change of the start and of the item. */
  private versions = { start: 0, item: 0 }
  private present: Present | null = null
  /** A start that was refused: the run of before stays. */
  private rejected: Start | null = null
  /** Where the present run goes. */
  private target: Target = { play: false }
  /** It has gone to `target.at`. */
  private arrived = true
  /** It is on the way there: it was taken back, if it had to be. */
  private placed = true
  /** Grows with each change that may make a step pointless that has begun. */
  private turn = 0
  private awake = false
  private wakeUp = (): void => undefined
  private readonly buffers = new Buffers(3)
  /** There is a state that was not shown. */
  private stale = false
  /** More has changed than where the run is: that is reported at once. */
  private news = true
  /** A picture waits for a buffer. */
  private blocked = false
  private lastFrame = 0
  private lastReport = 0
  /** When the next step is due. */
  private due = 0
  /** It was reported that a step takes long. */
  private waits = false
  private settled = false
  /** The part of the core that makes links is there. */
  private linked = false
  /** There are words. */
  private speaks = false
  private language = 'en'
  /** Until then something else is spoken. */
  spoken = Promise.resolve()
  /** Runs of other planners that the next step waits for. */
  private subtasks: { id: number; done(results: Finding[] | null): void } | null = null
  private asked = 0

  constructor(private readonly send: (message: FromHost, transfers?: Transferable[]) => void) {}

  get session(): Session | undefined {
    return this.present?.session
  }

  /** Vertices a layer of a frame may have. */
  get budget(): number {
    return this.desired.budget
  }

  /** The present run's link: refused where its code is too long for one. */
  linkOf(session: Session): Answer<string> {
    const { codeInLinks } = this.present ?? {}
    return codeInLinks?.ok === false ? codeInLinks : { ok: true, value: session.link() + (codeInLinks?.value ?? '') }
  }

  /** The number of the present run. */
  get generation(): number {
    return this.present?.reporter.run.generation ?? 0
  }

  /** Something else is wanted from now on. */
  want(version: number, change: Partial<Desired>): void {
    this.version = version
    Object.assign(this.desired, change)
    if ('start' in change) this.versions.start = version
    if ('item' in change) this.versions.item = version
    if ('members' in change) this.present?.reporter.askMembers()
    if (change.viewport) this.lookAt()
    if (change.item && !this.speaks) void this.learnToSpeak()
    if (change.language !== undefined) void this.speakIn(change.language)
    if (change.speed !== undefined) this.due = performance.now()
    if (change.start || change.target) {
      this.turn += 1
      this.dropSubtasks()
    }
    if (change.target && !this.pending) this.head(change.target)
    this.refresh()
  }

  /** A frame's buffer comes back. */
  giveBack(buffer: ArrayBuffer): void {
    this.buffers.giveBack(buffer)
    if (!this.blocked) return
    try {
      this.picture()
    } catch (error) {
      this.break(error)
    }
  }

  /** What runs of other planners found. */
  provide(id: number, results: Finding[] | null): void {
    if (this.subtasks?.id === id) this.subtasks.done(results)
  }

  /** Links can be made from now on. */
  link(): void {
    if (this.linked) return
    this.linked = true
    this.present?.reporter.forgetSettled()
    this.refresh()
  }

  /** What is explained needs words. */
  private async learnToSpeak(): Promise<void> {
    await words()
    this.speaks = true
    this.refresh()
  }

  /** What was said in another language is said once more. */
  private async speakIn(language: string): Promise<void> {
    if (language === this.language) return
    this.language = language
    this.spoken = speakIn(language)
    await this.spoken
    this.present?.reporter.repeat()
    // A refusal is said once more, too.
    this.rejected = null
    this.refresh()
  }

  /** The same state is reported once more. */
  private refresh(): void {
    this.settled = false
    this.stale = this.news = true
    this.wake()
  }

  /** Waits until there is the run that is wanted, and no step is half taken: only then there is something to say of it. False if there is none. */
  async untilStepEnds(): Promise<boolean> {
    while (this.pending || !this.present || this.present.session.partly) {
      if (!this.awake) return false
      await breathe()
    }
    return true
  }

  /** The core broke down, or something else that must not happen. */
  private break(error: unknown): void {
    this.onbroken(error)
  }

  onbroken: (error: unknown) => void = () => undefined

  /** Another start is wanted than that of the present run. */
  private get pending(): boolean {
    const { start } = this.desired
    return start !== null && start !== this.present?.start && start !== this.rejected
  }

  /** It is what is wanted, and where it is wanted. */
  private get reached(): boolean {
    if (this.pending) return false
    if (!this.present) return true
    const { session } = this.present
    return this.arrived && !session.partly && !(this.target.play && session.status === 'running')
  }

  private head(target: Target): void {
    const over = target.play && target.at === undefined && this.session !== undefined && this.session.status !== 'running'
    this.target = over ? { at: 0, play: true } : target
    this.arrived = this.target.at === undefined
    this.placed = false
    this.due = performance.now()
  }

  private lookAt(): void {
    const { window } = this.desired.viewport
    this.session?.lookAt(window?.min, window?.max)
  }

  private wake(): void {
    this.wakeUp()
    if (this.awake) return
    this.awake = true
    this.converge().then(
      () => (this.awake = false),
      (error: unknown) => this.break(error),
    )
  }

  private async converge(): Promise<void> {
    for (;;) {
      const { version } = this
      if (this.pending) await this.begin()
      else if (!this.reached) await this.advance()
      else if (await this.settle(version)) return
    }
  }

  /** Starts the run that is wanted, or leaves the present one as it is. */
  private async begin(): Promise<void> {
    const { start } = this.desired
    const version = this.versions.start
    if (!start) return
    const setup = await registered(start.setup)
    const accepted = setup.ok && start.check ? await silently(() => suggest(setup.value)) : null
    if (accepted?.ok) this.send({ is: 'accepted', version })
    stepping(0)
    const made = !setup.ok ? setup : accepted?.ok === false ? accepted : await silently(() => new Session(setup.value))
    const link = await codeInLinks(start.setup)
    if (start !== this.desired.start) {
      // Another one is wanted meanwhile.
      if (made.ok) made.value.free()
      return
    }
    if (!made.ok) {
      this.rejected = start
      if (this.desired.target) this.head(this.desired.target)
      this.send({ is: 'refused', version, refusal: made.refusal })
      return
    }
    this.present?.session.free()
    this.present = this.presented(start, made.value, version, link)
    this.rejected = null
    this.lookAt()
    if (this.versions.item < version) this.desired.item = null
    this.head(this.desired.target ?? start)
    this.stale = this.news = true
  }

  private presented(start: Start, session: Session, generation: number, codeInLinks: CodeInLinks): Present {
    const { planner, scene, seed, limit, parameters, evaluations } = session
    const run: Run = {
      generation,
      planner,
      scene,
      seed,
      limit,
      span: spanOf(session, 0),
      parameters,
      exact: session.exact(),
      evaluations,
      skeleton: scene.kind === 'arm' ? armPose(scene, homeOf(scene)).skeleton : [],
    }
    return {
      start,
      session,
      places: new Places(session, this.desired.clock),
      reporter: new Reporter(session, this.buffers, run, codeInLinks),
      codeInLinks,
    }
  }

  private async advance(): Promise<void> {
    if (!this.present) return
    if (this.arrived) await this.play(this.present)
    else await this.approach(this.present, this.target.at ?? 0)
  }

  /** Goes some of the way to a place. */
  private async approach({ session, places }: Present, at: number): Promise<void> {
    const known = places.iterationAt(at)
    if (!this.placed) this.place(known)
    const there = (): boolean => (known === null ? places.reaches(at) : session.iteration >= known) || session.status !== 'running'
    const fresh = places.isFurthest
    await this.slice(() => !session.partly && there())
    this.arrived ||= this.placed && !session.partly && there()
    // What was seen before is not shown again on the way.
    if (fresh && this.desired.underway) this.showWhenDue()
    await breathe()
  }

  /** Takes the run back where it can go on from, unless it is on its way already. */
  private place(known: number | null): void {
    this.placed = true
    if (!this.present) return
    const { session, places } = this.present
    if (known === null ? places.isFurthest : session.iteration === known && !session.partly) return
    session.rewind(known ?? places.report.iteration)
    this.stale = this.news = true
  }

  /** Plays for a while, or ends a step that has begun. */
  private async play({ session }: Present): Promise<void> {
    const { speed } = this.desired
    if (!this.target.play) {
      await this.step()
    } else if (speed === Infinity) {
      await this.slice(() => false)
    } else {
      const now = performance.now()
      if (now - this.due > LATE) this.due = now
      while (this.due <= now && session.status === 'running') {
        if (!(await this.step())) return
        this.due += 1000 / speed
      }
    }
    this.showWhenDue()
    if (session.status !== 'running' || speed === Infinity) await breathe()
    else await this.wait(this.due - performance.now())
  }

  /** Waits, unless something else is wanted. */
  private async wait(milliseconds: number): Promise<void> {
    await new Promise<void>((resolve) => {
      const timer = setTimeout(resolve, Math.max(0, milliseconds))
      this.wakeUp = () => {
        clearTimeout(timer)
        resolve()
      }
    })
    this.wakeUp = () => undefined
  }

  /** Steps for as long as a slice lasts. */
  private async slice(there: () => boolean): Promise<void> {
    const { session } = this
    const until = performance.now() + SLICE
    while (session && (session.status === 'running' || session.partly) && !there() && performance.now() < until) {
      if (!(await this.step())) return
    }
  }

  /** Takes a step, after the runs of other planners that it needs; false if it may be pointless now. */
  private async step(): Promise<boolean> {
    const { present, turn } = this
    if (!present) return false
    const { session, places } = present
    stepping(session.iteration + 1)
    const tasks = session.partly ? [] : session.jobs()
    if (tasks.length > 0) {
      const found = await this.carriedOut(present, tasks)
      if (turn !== this.turn) return false
      // Without it the step carries them out itself.
      if (found) session.supply(found)
    }
    // The step itself may take long as well: its own progress follows that of the runs.
    if (this.waits) this.progress(0, 0)
    const long = performance.now() + LONG
    const over = await step(session, () => {
      if (turn !== this.turn) return false
      if (!this.waits && performance.now() > long) this.progress(null, 1)
      return true
    })
    if (this.waits) this.progress(0, 0)
    if (!over) return false
    places.note()
    this.stale = true
    return true
  }

  private carriedOut({ reporter: { run } }: Present, tasks: Job[]): Promise<Finding[] | null> {
    this.asked += 1
    const id = this.asked
    this.send({ is: 'subtasks', id, ...this.nextStep, planner: run.planner, scene: run.scene, tasks })
    this.waits = true
    // What there is must be seen while it waits.
    this.news = true
    if (this.stale) this.picture()
    return new Promise((resolve) => {
      this.subtasks = {
        id,
        done: (results) => {
          this.subtasks = null
          resolve(results)
        },
      }
    })
  }

  private dropSubtasks(): void {
    const { subtasks, present } = this
    if (!subtasks || !present) return
    const { planner, scene } = present.reporter.run
    this.send({ is: 'subtasks', id: subtasks.id, ...this.nextStep, planner, scene, tasks: [] })
    subtasks.done(null)
  }

  private progress(done: number | null, total: number): void {
    this.waits = total > 0
    this.send({ is: 'progress', ...this.nextStep, done, total })
  }

  private get nextStep(): { generation: number; step: number } {
    return { generation: this.generation, step: (this.session?.iteration ?? 0) + 1 }
  }

  /** Shows the state in which it stays; false if something else is wanted meanwhile. */
  private async settle(version: number): Promise<boolean> {
    await breathe()
    // A run that has ended may say why.
    if (this.session && this.session.status !== 'running') await words()
    if (version !== this.version || !this.reached) return false
    if (this.target.play) this.target = { play: false }
    this.settled = true
    this.stale = this.news = true
    this.picture()
    return true
  }

  private showWhenDue(): void {
    const now = performance.now()
    if (now - this.lastFrame >= FRAME_INTERVAL - 1) this.picture()
  }

  private picture(): void {
    const { present } = this
    // A step that has begun is shown when it is over.
    if (!present || present.session.partly) return
    this.blocked = !present.reporter.ready
    if (this.blocked) return
    const { version, settled, desired, news } = this
    const now = performance.now()
    this.stale = false
    this.lastFrame = now
    const fast = desired.clock === 'iterations' && desired.speed > LEGIBLE
    if (fast && !news && now - this.lastReport < REPORT_INTERVAL) {
      const picture = present.reporter.picture(desired)
      this.send({ is: 'picture', ...picture }, Reporter.transfers(picture))
      return
    }
    this.news = false
    this.lastReport = now
    const state = { version, playing: !settled && this.target.play, arrived: settled, furthest: present.places.report }
    const wanted = { ...desired, item: this.speaks ? desired.item : null, links: this.linked && desired.links }
    const report = present.reporter.report(wanted, state)
    this.send(report, Reporter.transfers(report))
  }
}
