import type { Catalogue, Outcome, Scene, TrialCurve } from 'forage-lab'
import { AGAIN, moreIterations } from '../../../engine/budget'
import { codeOf } from '../../../catalogue/own'
import type { Values } from '../../../engine/trial.protocol'
import type { Refusal, Report, Run } from '../../../engine/protocol'
import { RunClient } from '../../../engine/run-client'
import { common } from '../../../locales/en/common'
import { type Names, namesOf } from '../../../render/looks'
import { sameScene } from '../../../scene/equality'
import { Outlet } from '../../../render/outlet'
import type { FieldRequest, HeightMap, Viewport } from '../../../render/frame'
import { markAt } from './standings'
import { foreseen } from './ticks'

/** A lane's run. */
export interface LaneRun extends Run {
  /** The most evaluations of one of its first steps. */
  most: number
}

/** How a lane runs. */
export interface Wanted {
  planner: string
  params: Values
  scene: Scene
  /** The budget that it spends with iterations that were chosen for it, and the most of them; null: with its own. */
  spends: { budget: number; iterations: number; most: number } | null
}

/** A run at a place, with its hash. */
interface Settled {
  iteration: number
  hash: string
}

/** Vertices a layer may have: several canvases are drawn at once. */
const BUDGET = 40_000

/** A planner in a race: its run, in a thread of its own whose clock is evaluations, and what was reported of it last. */
export class Lane {
  private wanted = $state.raw<Wanted | null>(null)
  readonly planner = $derived(this.wanted?.planner ?? '')
  readonly scene = $derived(this.wanted?.scene ?? null)
  /** What it is called. */
  label = $state('')
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

  /** Its planner's, if somebody wrote that. */
  private code: string | undefined
  private open = false
  private seed = 0
  /** With how many iterations it runs where its budget decides, and how often it had too few. */
  private iterations: number | null = null
  private again = 0
  /** Those who wait for the newest start, and for it to be where it goes. */
  private onstarted: ((begun: boolean) => void) | null = null
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

  /** `slot`: its place among the colours. */
  constructor(
    private readonly setup: { readonly catalogue: Catalogue | null },
    readonly slot: number,
  ) {}

  /** Takes a planner with its parameters; false if it runs with them already. */
  asks(wanted: Wanted): boolean {
    const { code } = codeOf(this.setup.catalogue?.planners.find(({ name }) => name === wanted.planner))
    const before = this.wanted
    const same =
      before !== null &&
      wanted.planner === before.planner &&
      code === this.code &&
      JSON.stringify([wanted.params, wanted.spends]) === JSON.stringify([before.params, before.spends]) &&
      sameScene(wanted.scene, before.scene) &&
      this.open
    this.wanted = wanted
    this.code = code
    return !same
  }

  /** The run begins again; of several starts the newest counts, the others are false. */
  start(seed: number): Promise<boolean> {
    this.seed = seed
    this.iterations = this.wanted?.spends?.iterations ?? null
    this.again = 0
    return this.begin()
  }

  private begin(): Promise<boolean> {
    this.crash = ''
    this.refusal = ''
    this.onstarted?.(false)
    this.arrive(null)
    const { wanted, code, seed, iterations } = this
    if (!wanted) return Promise.resolve(false)
    const { planner, scene } = wanted
    const params = iterations === null ? wanted.params : { iterations, ...wanted.params }
    this.client.want({ start: { setup: { planner, code, scene, params, seed }, at: 0, play: false }, summary: false })
    if (!this.open) {
      this.open = true
      void this.client.open()
    }
    return new Promise((resolve) => {
      this.onstarted = (begun) => {
        this.onstarted = null
        resolve(begun)
      }
    })
  }

  private receive(report: Report): void {
    if (report.run) {
      this.drop()
      this.refusal = ''
      this.run = { ...report.run, most: report.furthest.most }
      this.curve = report.curve
      if (!this.client.starting) this.onstarted?.(true)
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

  private refused({ message, unloaded }: Refusal): void {
    if (this.client.starting) return
    this.refuse(unloaded ? common.notices.unloaded(message) : message)
    this.onstarted?.(false)
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
  async go(clock: number): Promise<Report | null> {
    this.halted = false
    for (;;) {
      const report = await this.reach(clock)
      const more = report && this.lacks(report)
      if (more === null) return report
      this.pass(report)
      this.iterations = more
      this.again += 1
      const begun = this.begin()
      // It can be called back meanwhile, too.
      this.underway = true
      if (!(await begun) || this.halted) {
        this.underway = false
        return null
      }
    }
  }

  /** With how many iterations it has to begin again: those that it has end before its budget. */
  private lacks({ status, iteration, evaluations }: Report): number | null {
    const { iterations, run } = this
    const { spends } = this.wanted ?? {}
    if (!spends || iterations === null || !run || status === 'running' || this.again === AGAIN) return null
    return moreIterations({ iteration, evaluations, limit: run.limit }, iterations, spends.budget, spends.most)
  }

  private reach(clock: number): Promise<Report | null> {
    if (!this.racing) return Promise.resolve(null)
    this.arrive(null)
    this.underway = true
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

  field = async (request: FieldRequest): Promise<HeightMap | null> => (this.racing ? this.client.api.field(request) : null)

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
    this.onstarted?.(false)
    this.arrive(null)
    this.onsettled?.()
    this.run = null
    this.frames.clear()
    this.picture = null
    this.settled = null
  }
}
