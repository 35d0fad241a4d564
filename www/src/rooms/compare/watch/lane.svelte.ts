import type { Catalogue, Outcome, ParameterValue, Scene, TrialCurve } from 'forage-lab'
import { sameScene } from '../../../scene/equality'
import type { Refusal, Report, Run } from '../../../engine/protocol'
import { RunClient } from '../../../engine/run-client'
import { en } from '../../../locales/en/page'
import { type Names, namesOf } from '../../../render/looks'
import { Outlet } from '../../../render/outlet'
import type { FieldRequest, Viewport } from '../../../render/frame'
import { markAt } from './standings'
import { foreseen } from './ticks'

/** Of several that come at once the newest counts. */
export type Started = 'begun' | 'refused' | 'overtaken'

/** What a run is asked for. */
interface Asked {
  planner: string
  scene: Scene
  seed: number
  params: Record<string, ParameterValue>
}

/** A lane's run. */
export interface LaneRun extends Run {
  /** The most evaluations of one of its first steps. */
  most: number
}

/** A run at a place, with its hash. */
interface Settled {
  iteration: number
  hash: string
}

/** Vertices a layer may have: several canvases are drawn at once. */
const BUDGET = 40_000

let lanes = 0

/** A planner in a race: its run, in a thread of its own whose clock is evaluations, and what was reported of it last. */
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

  run = $state.raw<LaneRun | null>(null)
  /** What is shown of it; its frame is the renderer's. */
  picture = $state.raw<Report | null>(null)
  readonly frames = new Outlet(
    (buffer) => this.client.giveBack(buffer),
    () => void this.client.want({}),
  )
  /** Whose run it is: another planner may have been chosen. */
  readonly runner = $derived.by(() => this.setup.catalogue?.planners.find(({ name }) => name === (this.run?.planner ?? this.planner)))
  private readonly names = $derived.by<Names>(() =>
    this.setup.catalogue ? namesOf(this.setup.catalogue, this.runner) : { layers: [], shapes: [] },
  )
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
  readonly end = $derived(this.run && this.picture ? foreseen(this.picture.furthest, this.run.evaluations) : this.formerEnd)
  /** It takes part. */
  readonly racing = $derived(this.run !== null && this.refusal === '' && this.crash === '')

  private open = false
  /** By the newest start. */
  private asked: Asked | null = null
  /** Those who wait for the newest start, and for it to be where it goes. */
  private onstarted: ((started: Started) => void) | null = null
  private onarrived: ((picture: Report | null) => void) | null = null
  private onsettled: (() => void) | null = null

  private readonly client = new RunClient(
    {
      onopen: () => undefined,
      onreport: (report) => this.receive(report),
      onrefused: (refusal) => this.refused(refusal),
      onprogress: () => undefined,
      onbroken: (message) => this.fail(message),
      onreplaced: () => undefined,
    },
    { clock: 'evaluations', speed: Infinity, budget: BUDGET, summary: false, underway: false },
  )

  constructor(
    private readonly setup: { readonly catalogue: Catalogue | null },
    planner: string,
    params: Record<string, ParameterValue> = {},
  ) {
    lanes += 1
    this.id = lanes
    this.planner = planner
    this.params = params
    this.wanted = params
  }

  /** The run begins again, unless it is refused: then what runs is the run of before. */
  start(scene: Scene, params: Record<string, ParameterValue>, seed: number): Promise<Started> {
    this.crash = ''
    this.onstarted?.('overtaken')
    this.arrive(null)
    this.client.want({ start: { setup: { planner: this.planner, scene, params, seed }, at: 0, play: false }, summary: false })
    if (!this.open) {
      this.open = true
      void this.client.open()
    }
    this.asked = { planner: this.planner, scene, seed, params }
    return new Promise((resolve) => {
      this.onstarted = (started) => {
        this.onstarted = null
        resolve(started)
      }
    })
  }

  private receive(report: Report): void {
    if (report.run) {
      this.drop()
      this.refusal = ''
      this.run = { ...report.run, most: report.furthest.most }
      this.curve = report.curve
      if (!this.client.starting) this.onstarted?.('begun')
    } else if (report.curve) {
      this.curve = report.curve
    }
    const arrived = report.arrived && !this.client.starting && this.client.follows(report)
    if (arrived && this.onarrived) {
      this.arrive(report)
    } else if (arrived && report.iteration === this.picture?.iteration) {
      // A picture of the same state, seen otherwise or with its hash.
      this.show(report)
    } else {
      this.frames.pass(report.frame)
    }
  }

  private arrive(report: Report | null): void {
    const { onarrived } = this
    this.onarrived = null
    this.underway = false
    onarrived?.(report)
  }

  private refused({ field, message, unloaded }: Refusal): void {
    const { asked } = this
    if (this.client.starting || !asked) return
    const own = field !== '' && (field in asked.params || field in (this.run?.parameters ?? {}))
    if (own) this.errors = { ...this.errors, [field]: message }
    if (!own || !this.run || !this.runsOn(this.run, asked)) this.refuse(unloaded ? en.notices.unloaded(message) : message)
    this.onstarted?.('refused')
  }

  /** Of another planner, scene or seed it must not race on. */
  private runsOn(run: Run, { planner, scene, seed }: Asked): boolean {
    return run.planner === planner && run.seed === seed && sameScene(run.scene, scene)
  }

  private refuse(message: string): void {
    this.refusal = message
    this.run = null
    this.drop()
  }

  /** Nothing of another run may pass for this one's. */
  private drop(): void {
    this.formerEnd = this.end
    this.frames.clear()
    this.picture = null
    this.outcome = null
    this.curve = null
    this.settled = null
  }

  /** Where it is at a time of the race; nothing if it was called elsewhere meanwhile. */
  go(clock: number): Promise<Report | null> {
    if (!this.racing) return Promise.resolve(null)
    this.arrive(null)
    this.underway = true
    this.halted = false
    this.client.want({ target: { at: clock, play: false }, summary: false })
    return new Promise((resolve) => (this.onarrived = resolve))
  }

  /** Calls it back. */
  halt(): void {
    if (!this.underway) return
    this.halted = true
    this.client.want({ target: { play: false } })
    this.arrive(null)
  }

  show(picture: Report): void {
    if (this.picture !== picture) this.frames.put(picture.frame, this.names)
    this.picture = picture
    if (picture.outcome) this.outcome = picture.outcome
    const { iteration, hash } = picture
    if (hash !== null) this.settled = { iteration, hash }
    else if (this.settled?.iteration !== iteration) this.settled = null
    if (this.settled) this.onsettled?.()
  }

  /** Waits until its hash is there. */
  async settle(): Promise<void> {
    const { picture } = this
    if (!picture || !this.racing || this.settled?.iteration === picture.iteration) return
    this.client.want({ summary: true })
    await new Promise<void>((resolve) => (this.onsettled = resolve))
    this.onsettled = null
  }

  /** Opens the run where it is. */
  link = (): ReturnType<RunClient['api']['link']> => this.client.api.link()

  see = (viewport: Viewport): void => void this.client.want({ viewport })

  field = async (request: FieldRequest): Promise<ImageBitmap | null> => (this.racing ? this.client.api.field(request) : null)

  /** A picture that isn't shown. */
  pass(picture: Report | null): void {
    if (picture) this.frames.pass(picture.frame)
  }

  private fail(message: string): void {
    this.crash = message
    this.clear()
  }

  /** It takes part no more. */
  dismiss(): void {
    this.client.close()
    this.clear()
  }

  private clear(): void {
    this.open = false
    this.onstarted?.('refused')
    this.arrive(null)
    this.onsettled?.()
    this.run = null
    this.frames.clear()
    this.picture = null
    this.settled = null
  }
}
