import * as Comlink from 'comlink'
import type { Outcome, ParameterValue, Scene, UncheckedSetup, TrialCurve } from 'forage-lab'
import { Watchdog } from '../../../engine/watchdog'
import { sameScene } from '../../../scene/equality'
import type { Viewport } from '../../../render/frame'
import type { Answer } from '../../../engine/protocol'
import type { Picture, Settled, Start } from '../../../engine/race.protocol'
import type { RaceApi } from '../../../engine/host/race.worker'
import { foreseen } from './ticks'
import { markAt } from './standings'

/** Of several that come at once the newest counts. */
export type Started = 'begun' | 'refused' | 'overtaken'

/** What the run that is there was asked for. */
interface Begun {
  planner: string
  scene: Scene
  seed: number
}

let lanes = 0

/** A racer: its run, in a thread of its own, and what was told of it last. */
export class Lane {
  readonly id: number
  planner = $state('')
  /** What differs from the defaults. */
  params = $state.raw<Record<string, ParameterValue>>({})
  /** Those with what is wanted and not answered yet. */
  wanted: Record<string, ParameterValue>
  /** Messages by parameter name. */
  errors = $state.raw<Record<string, string>>({})
  /** Why it doesn't run here at all. */
  refusal = $state('')
  crash = $state('')

  run = $state.raw<Start | null>(null)
  picture = $state.raw<Picture | null>(null)
  outcome = $state.raw<Outcome | null>(null)
  curve = $state.raw<TrialCurve | null>(null)
  settled = $state.raw<Settled | null>(null)
  /** It is on its way to a time of the race. */
  underway = $state(false)
  /** It was called back from its last way. */
  halted = false

  readonly over = $derived(this.picture !== null && this.picture.status !== 'running')
  readonly mark = $derived(this.picture ? markAt(this.curve, this.picture.iteration) : null)
  /** Where its end was foreseen before it began again: the timeline keeps its length until there is a picture. */
  private formerEnd = $state(0)
  /** When it will be at its end. */
  readonly end = $derived(this.run && this.picture ? foreseen(this.picture.furthest, this.run.first) : this.formerEnd)
  /** It takes part. */
  readonly racing = $derived(this.run !== null && this.refusal === '' && this.crash === '')

  private worker: Worker | undefined
  private api: Comlink.Remote<RaceApi> | undefined
  private failed: Promise<never> | undefined
  /** What the thread was asked will never be answered. */
  private rejectPending: (reason: Error) => void = () => undefined
  private starts = 0
  /** Starts that the thread has not answered. */
  private pending = 0
  private readonly watchdog = new Watchdog(
    async () => this.api?.ping(),
    () => this.replace(),
  )
  private begun: Begun | null = null
  private looked: Viewport | null = null

  constructor(planner: string, params: Record<string, ParameterValue> = {}) {
    lanes += 1
    this.id = lanes
    this.planner = planner
    this.params = params
    this.wanted = params
  }

  /** After a crash it is a new thread. */
  private hire(): Comlink.Remote<RaceApi> {
    if (this.api) return this.api
    const worker = new Worker(new URL('../../../engine/host/race.worker.ts', import.meta.url), { type: 'module' })
    this.worker = worker
    this.failed = new Promise<never>((_, reject) => {
      this.rejectPending = reject
      worker.onerror = (event) => {
        event.preventDefault()
        reject(new Error(event.message || 'worker'))
      }
    })
    this.failed.catch(() => undefined)
    const api = Comlink.wrap<RaceApi>(worker)
    this.api = api
    if (this.looked) void this.ask(api.look(this.looked))
    return api
  }

  /** What the thread answers; nothing if it broke down. */
  private async ask<T>(answer: Promise<T>): Promise<T | null> {
    const { worker, failed } = this
    try {
      return await (failed ? Promise.race([answer, failed]) : answer)
    } catch (error) {
      if (worker === this.worker) this.fail(error)
      return null
    }
  }

  private fail(error: unknown): void {
    this.crash = error instanceof Error ? error.message : String(error)
    this.clear()
  }

  /** A start that keeps the thread from a newer one is given up. */
  private replace(): void {
    if (this.pending > 1) this.leave()
  }

  /** What the thread was asked is not answered any more. */
  private leave(): void {
    this.watchdog.stop()
    this.worker?.terminate()
    this.worker = undefined
    this.api = undefined
    this.rejectPending(new Error('dismissed'))
  }

  /** The run begins anew, unless it is refused: then what runs is the run of before. */
  async start(scene: Scene, params: Record<string, ParameterValue>, seed: number): Promise<Started> {
    this.starts += 1
    const turn = this.starts
    const setup: UncheckedSetup = { planner: this.planner, scene, params, seed }
    this.crash = ''
    let answer: Answer<Start> | null
    do {
      const api = this.hire()
      this.pending += 1
      this.watchdog.expect()
      answer = await this.ask<Answer<Start>>(api.start(setup) as Promise<Answer<Start>>)
      this.pending -= 1
      // Its thread was replaced.
    } while (!answer && turn === this.starts && this.crash === '')
    if (turn !== this.starts) return 'overtaken'
    if (!answer) return 'refused'
    if (!answer.ok) {
      const { field, message } = answer.refusal
      const own = field !== '' && (field in params || field in (this.run?.parameters ?? {}))
      if (own) this.errors = { ...this.errors, [field]: message }
      if (!own || !this.run || !this.begun || !this.runsOn(this.begun, scene, seed)) this.refuse(message)
      return 'refused'
    }
    this.refusal = ''
    this.run = answer.value
    this.begun = { planner: setup.planner, scene, seed }
    this.drop()
    return 'begun'
  }

  /** Of another planner, scene or seed it must not race on. */
  private runsOn(begun: Begun, scene: Scene, seed: number): boolean {
    return begun.planner === this.planner && begun.seed === seed && sameScene(begun.scene, scene)
  }

  private refuse(message: string): void {
    this.refusal = message
    this.run = null
    this.drop()
  }

  /** Nothing of another run may pass for this one's. */
  private drop(): void {
    this.formerEnd = this.end
    this.giveBack()
    this.picture = null
    this.outcome = null
    this.curve = null
    this.settled = null
  }

  /** Where it is at a time of the race; nothing if it was called elsewhere meanwhile. */
  async go(clock: number): Promise<Picture | null> {
    const { api, starts } = this
    if (!api || !this.racing) return null
    this.underway = true
    this.halted = false
    const picture = await this.ask(api.go(clock))
    this.underway = false
    if (picture && starts === this.starts) return picture
    this.pass(picture, starts)
    return null
  }

  /** Calls it back. */
  halt(): void {
    if (!this.underway) return
    this.halted = true
    void this.ask(this.api?.halt() ?? Promise.resolve())
  }

  show(picture: Picture): void {
    this.giveBack()
    this.picture = picture
    this.settled = null
    if (picture.curve) this.curve = picture.curve
    if (picture.outcome) this.outcome = picture.outcome
  }

  async settle(): Promise<void> {
    const { api, picture } = this
    if (!api || !picture || this.settled) return
    const settled = await this.ask(api.settle())
    if (!settled || settled.iteration !== this.picture?.iteration) return
    this.settled = settled
    this.outcome = settled.outcome
  }

  look = async (look: Viewport): Promise<void> => {
    this.looked = look
    const { api, starts } = this
    if (!api) return
    const picture = await this.ask(api.look(look))
    if (!picture) return
    // A picture of the same state, seen otherwise: what is known of it stays.
    if (starts !== this.starts || picture.iteration !== this.picture?.iteration) {
      this.pass(picture, starts)
      return
    }
    const { settled } = this
    this.show(picture)
    this.settled = settled
  }

  field: RaceApi['field'] = async (request) => (this.api ? this.ask(this.api.field(request)) : null)

  /** A picture that isn't shown; what it tells of the whole run is told only once. */
  pass(picture: Picture | null, starts = this.starts): void {
    if (!picture) return
    if (picture.curve && starts === this.starts) this.curve = picture.curve
    this.discard(picture)
  }

  private giveBack(): void {
    if (this.picture) this.discard(this.picture)
  }

  private discard({ buffer, fields }: Picture): void {
    for (const { bitmap } of fields) bitmap.close()
    if (buffer.byteLength > 0) void this.api?.giveBack(Comlink.transfer(buffer, [buffer]))
  }

  /** It takes part no more. */
  dismiss(): void {
    this.starts += 1
    this.clear()
  }

  private clear(): void {
    this.leave()
    this.run = null
    this.underway = false
    for (const { bitmap } of this.picture?.fields ?? []) bitmap.close()
    this.picture = null
    this.settled = null
  }
}
