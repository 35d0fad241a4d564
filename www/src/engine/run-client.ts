import { asking } from '../render/asking'
import type { Questions } from './host/questions'
import { type Host, host } from './host'
import {
  DEFAULTS,
  type Desired,
  type FromHost,
  type Picture,
  type Progress,
  type Refusal,
  type Report,
  type Start,
  type Target,
  type ToHost,
} from './protocol'
import { language } from '../locales/language.svelte'
import type { SubtaskRunner } from './subtasks'
import { HEARTBEAT, UNSTOPPABLE, Watchdog } from './watchdog'

/** Of what a thread was asked that broke down: it is not asked again, for that may be why. */
export class Gone extends Error {
  override name = 'Gone'
}

export interface Listeners {
  onreport(report: Report): void
  /** Between reports. */
  onpicture?(picture: Picture): void
  /** The setup of a start that is to be checked is accepted. */
  onaccepted?(version: number): void
  /** A start was refused; the run of before stays. `version`: the number of the change that wanted it. */
  onrefused(refusal: Refusal, version: number): void
  /** Null: no step takes long any more. */
  onprogress(progress: Progress | null): void
  /** The thread is there. */
  onopen(): void
  onbroken(message: string): void
  /** The thread did not receive what it was sent; another one takes its place. `slowed`: with an interpreter around the code. */
  onreplaced(slowed: boolean): void
  /** A step of somebody's code did not end: the run is where it was before. Absent: that is a breakdown. */
  onstuck?(): void
}

/** How often the progress of runs that a step needs is reported, in milliseconds. */
const PROGRESS_INTERVAL = 100

/** A message as it is given: its number is added when it is sent. */
type Unnumbered<M> = M extends unknown ? Omit<M, 'number'> : never

interface Asked {
  number: number
  name: string
  given: unknown[]
  resolve(value: unknown): void
  reject(reason: Error): void
}

/**
 * A run in a thread of its own. What is wanted of it is one state, `desired`; each change is sent, and the thread converges to the
 * newest. A thread that does not receive for three seconds is replaced by one that gets the whole state. After a breakdown a new one
 * is started only by `open`: the same state may break it down again.
 */
export class RunClient {
  readonly desired: Desired
  /** The number of the newest change. */
  version = 0
  private worker: Worker | undefined
  /** The thread has the core: what is sent before waits for that. */
  private opened = false
  /** The run that is there, where it was when it was last reported, and where it goes. */
  private present: { start: Start; at: number; target: Target } | null = null
  /** Of the newest start or target. */
  private followed = 0
  /** Of the newest item. */
  private chosen = 0
  /** Starts of which nothing is known yet. */
  private begins: { version: number; start: Start }[] = []
  private sent = 0
  private seen = 0
  private receipts: { number: number; resolve(): void }[] = []
  private asked: Asked[] = []
  private readonly watchdog = new Watchdog(
    () => this.received(),
    () => this.replace(),
  )
  private subtasks: SubtaskRunner | undefined
  /** The request for subtasks that the next step waits for. */
  private needed = 0
  private lastProgress = 0
  /** The number of a start whose code did not end: it is refused once the run of before is there again. */
  private stuck = 0
  private heartbeat: ReturnType<typeof setInterval> | undefined

  constructor(
    private readonly listeners: Listeners,
    wanted: Partial<Desired> = {},
    private readonly hosting: () => Host = host,
  ) {
    this.desired = { ...DEFAULTS, language: language.tag, ...wanted }
  }

  /** Starts a thread. It begins with all that is wanted. */
  async open(): Promise<void> {
    this.close()
    language.listeners.add(this.speak)
    this.desired.language = language.tag
    const worker = this.hosting().worker('run')
    this.worker = worker
    worker.onmessage = ({ data }: MessageEvent<FromHost>) => {
      if (worker === this.worker) this.receive(data)
    }
    worker.onerror = (event) => {
      event.preventDefault()
      if (worker === this.worker) this.break(event.message || 'worker')
    }
    const host = this.hosting()
    const [core, files] = await Promise.all([host.core(), host.files?.()])
    if (worker !== this.worker) return
    this.opened = true
    this.post({ is: 'open', core, files })
    this.begins = []
    this.change({ ...this.desired })
    for (const asked of this.asked) this.put(asked)
  }

  private readonly speak = (): void => {
    this.want({ language: language.tag })
  }

  /** Another state is wanted; returns the number of this change. */
  want(change: Partial<Desired>): number {
    // Where a start goes is said with it.
    if (change.start) this.stuck = 0
    return this.change(change.start && change.target === undefined ? { ...change, target: null } : change)
  }

  private change(change: Partial<Desired>): number {
    this.version += 1
    Object.assign(this.desired, change)
    if (change.start) this.begins.push({ version: this.version, start: change.start })
    else if (change.target && this.present && !this.starting) this.present.target = change.target
    if (change.start || change.target) this.followed = this.version
    if ('item' in change) this.chosen = this.version
    this.post({ is: 'want', version: this.version, change })
    if (change.start) this.beat()
    return this.version
  }

  /** A code may never come to an end: without an interpreter, or within what is built into that. */
  private beat(): void {
    const runs = (this.begins.at(-1) ?? this.present)?.start.setup.code !== undefined
    // What has run before has an end, however long it takes.
    const waits = (runs && !this.isAsked('states')) || this.isAsked('read')
    if (!waits) this.stopBeating()
    else this.heartbeat ??= setInterval(() => this.post({ is: 'ping' }), HEARTBEAT)
  }

  private stopBeating(): void {
    clearInterval(this.heartbeat)
    this.heartbeat = undefined
  }

  private isAsked(question: keyof Questions): boolean {
    return this.asked.some(({ name }) => name === question)
  }

  /** Whether a report follows the newest start and target. */
  follows({ version }: Pick<Report, 'version'>): boolean {
    return version >= this.followed
  }

  /** A start was wanted of which nothing is known yet. */
  get starting(): boolean {
    return this.begins.length > 0
  }

  /** Where the run goes that is there, or the one that is to take its place. */
  get heading(): Target {
    const begin = this.begins.at(-1)
    if (begin) return this.desired.target ?? { at: begin.start.at, play: begin.start.play }
    return this.present?.target ?? { play: false }
  }

  /** For questions: `client.api.pick(1, 2, 3)`. They fail with `Gone` if the thread breaks down. */
  readonly api = asking<Questions>((name, given) => this.ask(name, given))

  private ask(name: string, given: unknown[]): Promise<unknown> {
    return new Promise((resolve, reject) => {
      const asked = { number: 0, name, given, resolve, reject }
      this.asked.push(asked)
      this.put(asked)
      this.beat()
    })
  }

  /** Asks the present thread. */
  private put(asked: Asked): void {
    asked.number = this.post({ is: 'ask', question: { name: asked.name, given: asked.given } })
  }

  /** Needs no receipt: a frame comes for it. */
  giveBack(buffer: ArrayBuffer): void {
    if (this.opened) this.worker?.postMessage({ is: 'buffer', number: 0, buffer } satisfies ToHost, [buffer])
  }

  /** Ends the thread; what is wanted is kept for the next one. */
  close(): void {
    language.listeners.delete(this.speak)
    this.watchdog.stop()
    this.stopBeating()
    this.subtasks?.drop()
    this.worker?.terminate()
    this.worker = undefined
    this.opened = false
    this.seen = this.sent
    this.settleReceipts()
  }

  private post(message: Unnumbered<ToHost>, transfers: Transferable[] = []): number {
    this.sent += 1
    if (this.worker && this.opened) {
      this.worker.postMessage({ ...message, number: this.sent }, transfers)
      this.watchdog.expect()
    }
    return this.sent
  }

  /** Resolves when the thread has received what it was sent. */
  private received(): Promise<void> {
    const number = this.sent
    if (!this.worker || this.seen >= number) return Promise.resolve()
    return new Promise((resolve) => this.receipts.push({ number, resolve }))
  }

  private settleReceipts(): void {
    const settled = this.receipts.filter(({ number }) => number <= this.seen)
    this.receipts = this.receipts.filter(({ number }) => number > this.seen)
    for (const { resolve } of settled) resolve()
  }

  private receive(message: FromHost): void {
    switch (message.is) {
      case 'open':
        this.listeners.onopen()
        break
      case 'seen':
        this.seen = Math.max(this.seen, message.number)
        this.settleReceipts()
        break
      case 'report':
        this.report(message)
        break
      case 'picture':
        if (this.listeners.onpicture) this.listeners.onpicture(message)
        else this.giveBack(message.frame.buffer)
        break
      case 'accepted':
        this.listeners.onaccepted?.(message.version)
        break
      case 'refused':
        this.refused(message.version)
        this.listeners.onrefused(message.refusal, message.version)
        break
      case 'progress':
        this.listeners.onprogress(message.total > 0 ? message : null)
        break
      case 'answer':
        this.answered(message)
        break
      case 'subtasks':
        void this.carryOut(message)
        break
      case 'broken':
        this.break(message.message)
        break
    }
  }

  private report(report: Report): void {
    const { generation } = report
    const at = this.desired.clock === 'iterations' ? report.iteration : report.evaluations
    if (report.run) {
      const start = this.begins.find(({ version }) => version === generation)?.start
      this.begins = this.begins.filter(({ version }) => version > generation)
      // An item of the run before is none of this one.
      if (this.chosen < generation) this.desired.item = null
      if (start) this.present = { start, at, target: this.desired.target ?? { at: start.at, play: start.play } }
    }
    const { present } = this
    if (present) {
      present.at = at
      // It is where it was wanted, or at its end.
      if (!this.starting && this.follows(report)) {
        if (report.arrived) present.target = { play: false }
        else if (report.playing && at >= (present.target.at ?? 0)) present.target = { play: true }
      }
    }
    this.listeners.onreport(report)
    if (!report.run || this.stuck === 0) return
    this.listeners.onrefused({ message: UNSTOPPABLE, field: 'code' }, this.stuck)
    this.stuck = 0
  }

  /** The run of before stays, and goes where it was wanted since. */
  private refused(before: number): void {
    this.begins = this.begins.filter(({ version }) => version > before)
    const { present, desired } = this
    if (!present || this.starting) return
    present.target = desired.target ?? present.target
    desired.start = present.start
    this.beat()
    desired.target = present.target
  }

  private answered({ number, value, error }: { number: number; value?: unknown; error?: string }): void {
    const asked = this.asked.find((candidate) => candidate.number === number)
    if (!asked) return
    this.asked = this.asked.filter((other) => other !== asked)
    this.beat()
    if (error === undefined) asked.resolve(value)
    else asked.reject(new Error(error))
  }

  /** Carries out runs of other planners that a step needs, in other threads. */
  private async carryOut({ id, generation, step, planner, scene, tasks }: FromHost & { is: 'subtasks' }): Promise<void> {
    this.needed = tasks.length > 0 ? id : 0
    if (tasks.length === 0) {
      this.subtasks?.drop()
      return
    }
    const { worker } = this
    const { SubtaskRunner: Runner } = await import('./subtasks')
    this.subtasks ??= new Runner()
    if (worker !== this.worker || this.needed !== id) return
    const results = await this.subtasks.carryOut({ planner, scene }, tasks, (done) => {
      const now = performance.now()
      if (now - this.lastProgress < PROGRESS_INTERVAL) return
      this.lastProgress = now
      this.listeners.onprogress({ is: 'progress', generation, step, done, total: tasks.length })
    })
    if (worker === this.worker) this.post({ is: 'results', id, results })
  }

  private break(message: string): void {
    this.close()
    const { asked } = this
    this.asked = []
    this.resume(false)
    for (const { reject } of asked) reject(new Gone(message))
    this.listeners.onbroken(message)
  }

  private replace(): void {
    const { present } = this
    const begin = this.begins.at(-1)
    const setup = (begin ?? present)?.start.setup
    const runsCode = setup?.code !== undefined
    const stands = !begin && present?.target.play === false && (present.target.at ?? present.at) === present.at
    // What was asked that may be why is not asked again.
    const suspects = this.asked.filter(({ name }) => name === 'states' || (name === 'read' && (stands || !runsCode)))
    this.asked = this.asked.filter((one) => !suspects.includes(one))
    const reads = suspects.filter(({ name }) => name === 'read')
    if (!runsCode || setup.full || suspects.length > 0) {
      this.close()
      this.resume(true)
      this.listeners.onreplaced(reads.length === 0 && (setup?.full ?? false))
    } else if (present && (begin || this.listeners.onstuck)) {
      // The same code would not stop again: the run of before stays, or this one where it was.
      this.close()
      this.begins = []
      this.resume(false)
      this.listeners.onreplaced(false)
      if (begin) this.stuck = begin.version
      else this.listeners.onstuck?.()
    } else {
      this.break(UNSTOPPABLE)
      return
    }
    for (const { name, resolve, reject } of suspects)
      if (name === 'read') resolve({ ok: false, refusal: { message: UNSTOPPABLE, field: 'code' } })
      else reject(new Gone(UNSTOPPABLE))
    void this.open()
  }

  /** What the next thread begins with: what is wanted, from where the run was. `goesOn`: on its way or playing, if it was. */
  private resume(goesOn: boolean): void {
    const { desired, present, heading } = this
    const begin = this.begins.at(-1)?.start
    const start = begin ?? present?.start
    if (!start) return
    const from = begin ? begin.at : (present?.at ?? 0)
    // A code without an interpreter may be why the thread did not answer.
    const setup = start.setup.full ? { ...start.setup, full: false } : start.setup
    desired.start = { setup, at: goesOn ? (heading.at ?? from) : from, play: goesOn && heading.play }
    desired.target = null
    this.begins = [{ version: this.version, start: desired.start }]
  }
}
