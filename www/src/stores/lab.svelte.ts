import type { Catalogue, Layer, LinkSetup, Look, Outcome, ParameterValue, Planner, Scene, UncheckedSetup, Status, When } from 'forage-lab'
import { en } from '../locales/en/page'
import type { FrameMessage, Opening, Refusal, Run } from '../engine/protocol'
import { address } from './address'
import { meaningful, met } from '../catalogue/parameters'
import { Client } from '../engine/run-client'
import type { Clock } from './clock.svelte'
import { Course } from './history.svelte'
import { Followers } from './followers.svelte'
import type { Follower } from './following.svelte'
import type { Again } from './scenes.svelte'
import { Inspecting } from './inspecting.svelte'
import { layerOf, type Names, namesOf, PLAIN } from '../render/looks'
import { missing, stageAt } from '../catalogue/stages'
import { suits } from '../scene/stops'
import { Suggested } from './suggested.svelte'
import { stillness } from './theme.svelte'
import { worded } from './transport.svelte'
import { views } from './views.svelte'
import { Visible } from './layers.svelte'

const FIRST = { planner: 'wcpso', scene: 'wcpso-discs', seed: 1 }

/** What a tuning came to: a planner and its parameters. */
export interface Tuned {
  planner: string
  params: Record<string, ParameterValue>
}

export type Phase = 'loading' | 'ready' | 'crashed'
/** Which optimum results are measured by. Only in a grid and of tours there is more than one. */
export type Yardstick = 'plain' | Outcome['exact_by']

/** A part of the core could not be loaded: what follows from it, in words, and what asks again. */
interface Unloaded {
  message: string
  ask(): Promise<unknown>
}

/** Everything the page knows. Components read it and call its methods; nothing else holds state of the run. */
export class Lab extends Inspecting {
  phase = $state<Phase>('loading')
  crash = $state('')
  catalogue = $state.raw<Catalogue | null>(null)

  plannerName = $state(FIRST.planner)
  seed = $state(FIRST.seed)

  run = $state.raw<Run | null>(null)
  frame = $state.raw<FrameMessage | null>(null)
  /** The first picture is on the screen: what it did not need may come. */
  drawn = $state(false)
  computed = $state(0)
  status = $state<Status>('running')
  readings = $state.raw<Record<string, number>>({})
  outcome = $state.raw<Outcome | null>(null)
  hash = $state('')
  readonly course = new Course()

  /** The members' numbers, row by row, while somebody asks for them. */
  members = $state.raw<Float64Array | null>(null)
  private tuner: Tuned | null = null
  readonly visible = new Visible()
  readonly suggested = new Suggested()
  sceneError = $state.raw<Refusal | null>(null)
  unloaded = $state.raw<Unloaded | null>(null)
  private readonly startAgain = (): Promise<void> => this.restart(this.requested)
  /** The newest run did not start: what runs is the run of before. */
  readonly failed = $derived(this.sceneError !== null || this.unloaded?.ask === this.startAgain)
  notice = $state('')
  /** A random map is being made. */
  making = $state(false)
  readonly planner = $derived<Planner | null>(this.catalogue?.planners.find(({ name }) => name === this.plannerName) ?? null)
  /** The planner that drew the frame: another one may have been chosen. */
  private readonly drawer = $derived(this.catalogue?.planners.find(({ name }) => name === this.frame?.planner))
  readonly names = $derived<Names | null>(this.catalogue && namesOf(this.catalogue, this.drawer))
  /** What is looked for is a tour through the stops: start and goal mean nothing. */
  readonly touring = $derived(this.scene?.kind === 'tour' || (this.grid !== null && (this.planner?.stops ?? false)))
  /** It tells what happens and what it decides. */
  readonly eventful = $derived((this.planner?.events.length ?? 0) > 0)
  /** It plans in an arm's joints, and tells of each node: its costs are angles. */
  readonly inJoints = $derived(this.planner?.members.some(({ name }) => name === 'q1') ?? false)
  private readonly span = $derived(this.course.of(this.run))
  /** The iteration at which the run ends, or, while that is open, at which it ends at the latest. */
  readonly limit = $derived(this.span.end ?? this.run?.limit ?? 0)
  /** How many iterations the timeline shows. */
  readonly extent = $derived(this.span.extent)
  /** Where the run ends is not known yet. */
  readonly openEnded = $derived(this.span.end === null)
  readonly stages = $derived(this.span.stages)
  readonly yardstick = $derived<Yardstick>((this.grid || this.touring) && this.outcome ? this.outcome.exact_by : 'plain')
  /** The optimum that results are measured by, in words. */
  readonly optimum = $derived(this.arm ? en.result.tip : en.result[this.planner?.stops ? 'tours' : 'optimum'][this.yardstick])
  /** The part of the run that it is in, and how far in it. */
  readonly part = $derived(stageAt(this.stages, this.iteration))
  /** How far a step is that takes its time. */
  readonly underway = $derived(this.progress?.generation === this.run?.generation ? this.progress : null)
  readonly finished = $derived(this.status !== 'running')
  /** What is done before there can be a result: how many of the roads between the stops stand. */
  readonly building = $derived(missing(this.planner, this.grid, this.readings, this.outcome, this.finished))

  protected readonly client = new Client({
    onframe: (frame) => this.receive(frame),
    onprogress: (progress) => (this.progress = progress.total > 0 ? progress : null),
    oncrash: (message) => this.breakDown(message),
    onunresponsive: () => this.replace(),
  })
  readonly followers = new Followers()
  /** An iteration is shown step by step. */
  unfolded = $state(false)
  /** A time beside that of the run that the stage's keys are for, and the way back. */
  beside = $state.raw<{ clock: Clock; leave(): void } | null>(null)
  /** There is a path of this very scene to follow. */
  readonly followable = $derived(this.outcome?.length != null && !this.stale && !this.failed && this.target === null)
  readonly drivable = $derived(this.hasRobot && this.followable)
  /** The fingerprint that an opened link promises, and where. */
  private promised: { hash: string; at: number } | undefined
  /** A start is on its way. */
  private starting = false
  protected get restarting(): boolean {
    return this.outdated && (this.starting || !this.failed)
  }
  /** The next restart waits for the answer to that start. */
  private restartsAgain = false
  /** The run was going on when the robot set off. */
  private resumes = false

  /** Once more, after a part could not be loaded. */
  retry = async (): Promise<void> => {
    const { unloaded } = this
    await unloaded?.ask()
    // Otherwise it has failed again.
    if (this.unloaded === unloaded) this.unloaded = null
  }

  /** Starts a thread. After a crash, or in place of another one, it begins with what the user had made, where it was wanted last. */
  async open(): Promise<void> {
    try {
      this.catalogue = await this.client.open()
    } catch (error) {
      this.breakDown(error instanceof Error ? error.message : String(error))
      return
    }
    this.phase = 'ready'
    this.crash = ''
    // A new thread counts its runs anew: nothing of the old one may pass for its.
    this.frame = null
    this.course.clear()
    await this.client.api.speed(this.speed)
    this.askAgain()
    while (this.awaited.length > 0) await Promise.allSettled(this.awaited)
    if (this.scene) {
      // What was asked, or wanted meanwhile, may have led to another start.
      if (!this.starting && !this.frame) await this.restart(this.requested)
      return
    }
    this.put(this.shipped(FIRST.scene), false)
    const opened = location.hash.length > 1 && !views.named(location.hash) && (await this.openLink(location.hash))
    if (!opened) await this.restart({ at: 0, play: views.current === 'stage' && !stillness.matches })
  }

  private shipped(name: string): Scene {
    const scenes = this.catalogue?.scenes ?? []
    const scene = scenes.find((candidate) => candidate.name === name) ?? scenes[0]
    if (!scene) throw new Error('no scene ships')
    return scene
  }

  protected override put(scene: Scene, step: boolean): void {
    this.requests.note('scene')
    super.put(scene, step)
  }

  openLink = async (link: string): Promise<boolean> => {
    const request = this.requests.note('setup', 'seed', 'parameters')
    let opened = true
    await this.await(
      async () => this.api.parseLink(link),
      (answer) => {
        opened = answer.ok
        if (!answer.ok) this.warn(answer.refusal, en.notices.link(answer.refusal.message), () => this.openLink(link))
        else if (!this.requests.replaced(request, 'setup')) this.openSetup(answer.value, request)
      },
    )
    return opened
  }

  private openSetup({ planner, scene, params, seed, iteration, hash }: LinkSetup, request: number): void {
    this.plannerName = planner
    // A page that opens on a link has nothing to go back to.
    this.put(scene, this.run !== null)
    this.params = params
    this.paramErrors = {}
    this.seed = seed
    this.promised = hash === undefined ? undefined : { hash, at: iteration }
    this.notice = ''
    void this.restart({ at: iteration, play: false }, request)
  }

  /**
   * Starts a new run. One start is on its way at a time; the newest of the restarts that are requested meanwhile follows it.
   * A seek, play or pause that was requested after the change, number `since`, holds for the new run.
   */
  private async restart(opening: Opening, since = this.requests.note('setup')): Promise<void> {
    this.stopPlayback()
    this.putAt(opening, since)
    this.restartsAgain = true
    this.outdated = true
    if (this.starting) {
      // That start may be what keeps the worker from this one.
      this.client.expect()
      return
    }
    this.starting = true
    try {
      while (this.restartsAgain) {
        this.restartsAgain = false
        await this.begin(this.requested)
      }
    } finally {
      this.starting = false
      // The first picture may have come before the answer.
      if (!this.failed && this.frame && this.frame.generation === this.run?.generation) {
        this.outdated = false
        this.compare(this.frame)
      }
    }
  }

  protected setup(scene: Scene, values: Record<string, ParameterValue>): UncheckedSetup {
    const params = this.planner ? meaningful(this.planner, scene, values) : {}
    return { planner: this.plannerName, scene, params, seed: this.seed }
  }

  private async begin(opening: Opening): Promise<void> {
    const { scene, requests } = this
    if (!scene || this.phase !== 'ready') return
    const setup = this.setup(scene, this.params)
    const request = requests.note('run')
    const answer = worded(await this.client.api.start(setup, opening, request))
    if (this.unloaded?.ask === this.startAgain) this.unloaded = null
    if (!answer.ok) {
      this.refuse(answer.refusal)
      return
    }
    void this.suggested.ask(this.api, setup, this.scene?.kind)
    this.run = answer.value
    this.sceneError = null
    // Pictures and requests may have overtaken the answer.
    const { limit, generation } = answer.value
    const settled = this.frame?.generation === generation && this.frame.report?.settledHash != null
    if (!settled) this.hash = ''
    if (requests.replaced(request, 'iteration')) this.target = this.target === null ? null : Math.min(this.target, limit)
    else if (!settled) this.target = opening.at > 0 ? Math.min(opening.at, limit) : null
    if (!settled && !requests.replaced(request, 'playing')) this.playing = opening.play
    if (!requests.replaced(request, 'inspection')) {
      this.inspection = null
      this.item = null
    }
  }

  /** How a layer of the frame, of an explanation or of the scene looks. */
  lookOf = (key: string): Look => layerOf(this.catalogue, this.drawer, key)?.look ?? PLAIN

  /** Whether a condition on the parameters is met. */
  met = (when: When | undefined): boolean =>
    Boolean(this.planner && this.scene && met(when, this.planner.parameters, this.scene.kind, this.params))

  /** The layers that there can be with these parameters. */
  readonly layers = $derived<Layer[]>(
    this.planner?.layers.filter(({ when, kinds }) => this.scene && (kinds?.includes(this.scene.kind) ?? true) && this.met(when)) ?? [],
  )

  private refuse(refusal: Refusal): void {
    if (refusal.unloaded) {
      this.sceneError = null
      this.warn(refusal, refusal.message, this.startAgain)
    } else if (this.planner?.parameters.some(({ name }) => name === refusal.field)) {
      this.paramErrors = { ...this.paramErrors, [refusal.field]: refusal.message }
      // What runs is still the run of before.
      this.outdated = false
    } else {
      this.sceneError = refusal
    }
  }

  /** Says what was refused; where nothing was but a part could not be loaded, `ask` is offered. */
  warn(refusal: Refusal, message: string, ask: () => Promise<unknown>): void {
    if (refusal.unloaded) this.unloaded = { message, ask }
    else this.notice = message
  }

  private breakDown(message: string): void {
    this.crash = message
    this.leaveThread('crashed', { at: this.iteration, play: false })
    this.forget()
  }

  /** What the thread computes keeps it from what is wanted of it: a new one begins with that. */
  private replace(): void {
    // A start may take its time, unless a change waits for it.
    if (this.phase !== 'ready' || (this.starting && !this.restartsAgain && this.awaited.length === 0)) return
    this.leaveThread('loading', this.resumption)
    void this.open()
  }

  /** A new thread begins at `resumption`, or where the user wants it until then. */
  private leaveThread(phase: 'crashed' | 'loading', resumption: Opening): void {
    this.phase = phase
    this.stopPlayback()
    this.requested = resumption
    this.outdated = true
    this.progress = null
    this.starting = false
    this.restartsAgain = false
    this.client.close()
  }

  private receive(frame: FrameMessage): void {
    const previous = this.frame
    if (previous) this.client.giveBack(previous.buffer)
    for (const { bitmap } of previous?.fields ?? []) bitmap.close()
    const anew = frame.generation !== previous?.generation
    this.frame = frame
    if (!previous) requestAnimationFrame(this.seen)
    this.course.receive(frame, anew)
    this.iteration = frame.iteration
    this.computed = frame.computed
    this.status = frame.status
    this.readings = frame.readings
    this.inspection = frame.inspection
    if (frame.members || anew) this.members = frame.members
    if (this.run?.generation === frame.generation && !this.starting && !this.failed) this.outdated = false
    // It goes on playing where it was sent.
    if (frame.playing && this.target !== null && frame.iteration >= this.target && this.isNewest(frame)) this.target = null
    if (frame.report) this.receiveReport(frame, frame.report)
    else this.hash = ''
  }

  /** The first picture of a thread is on the screen. */
  private readonly seen = (): void => {
    performance.mark('first-picture')
    this.drawn = true
    void this.client.api.drawn()
  }

  private receiveReport(frame: FrameMessage, report: NonNullable<FrameMessage['report']>): void {
    this.outcome = report.outcome
    const newest = this.isNewest(frame)
    this.hash = (newest ? report.settledHash : null) ?? ''
    if (!newest) return
    if (report.settledHash === null) {
      if (report.link !== null) address.soon(report.link)
      return
    }
    this.playing = frame.playing
    this.target = null
    this.progress = null
    this.followers.heed(frame)
    if (report.link !== null) address.now(report.link)
    this.compare(frame)
  }

  /** Whether the run of a link is the one that the link promises. A picture of the run before it says nothing of that. */
  private compare({ generation, iteration, report }: FrameMessage): void {
    const hash = report?.settledHash
    if (this.starting || generation !== this.run?.generation || this.promised?.at !== iteration || hash == null) return
    if (this.promised.hash !== hash) this.notice = en.notices.hash
    this.promised = undefined
  }

  // What is planned with what

  protected again(where: Again = 'anew', since?: number): void {
    this.promised = undefined
    const { scene, planner } = this
    // An edit that leaves the planner too little is refused, and undone: nothing takes its place.
    const another = scene?.kind !== this.run?.scene.kind || scene?.name !== this.run?.scene.name
    if (scene && planner && another && !suits(planner, scene)) this.suit(scene)
    if (where === 'on' || (where === 'here' && this.restarting)) {
      void this.restart(this.requested, since)
      return
    }
    const at = where === 'here' && !this.finished ? (this.target ?? this.iteration) : 0
    void this.restart({ at, play: this.playing || !this.run || (this.finished && !stillness.matches) }, since)
  }

  setPlanner = (name: string): void => {
    const planner = this.catalogue?.planners.find((candidate) => candidate.name === name)
    if (!planner || name === this.plannerName) return
    this.paramErrors = {}
    if (this.tuner?.planner === name) this.replaceParameters(this.tuner.params)
    this.tuner = null
    this.plannerName = name
    // Where it doesn't run, it brings a scene of its own.
    const other = this.scene && !suits(planner, this.scene) && this.catalogue?.scenes.find((scene) => suits(planner, scene))
    if (other) this.put(other, true)
    this.again()
  }

  openScene = (scene: Scene): void => {
    this.notice = ''
    this.put(scene, true)
    this.again()
  }

  /** A planner, a scene, parameters and a seed at once: they show what was meant to be seen. */
  openCase = (planner: string, scene: Scene, params: Record<string, ParameterValue>, seed = FIRST.seed): void => {
    this.notice = ''
    this.paramErrors = {}
    this.tuner = null
    this.promised = undefined
    this.plannerName = planner
    this.replaceParameters(params)
    this.seed = seed
    this.requests.note('seed')
    if (scene !== this.scene) this.put(scene, true)
    void this.restart({ at: 0, play: !stillness.matches })
  }

  /** Another planner takes the place of one that doesn't run on such scenes. */
  private suit(scene: Scene): void {
    const other = this.catalogue?.planners.find((planner) => suits(planner, scene))
    if (!other) return
    this.notice = en.notices.kind(this.planner?.title ?? '', scene.title, other.title)
    this.paramErrors = {}
    this.plannerName = other.name
  }

  /** Runs the planner that was tuned, with what the tuning came to. The tuner's own parameters wait for its return. */
  useTuned = ({ planner, params }: Tuned): void => {
    this.tuner = { planner: this.plannerName, params: this.params }
    this.paramErrors = {}
    this.plannerName = planner
    this.replaceParameters(params)
    this.again()
  }

  setSeed = (seed: number): void => {
    this.requests.note('seed')
    this.seed = seed
    this.again()
  }

  newSeed = (): Promise<void> => {
    const request = this.requests.note('seed')
    return this.await(
      () => this.api.newSeed(),
      (seed) => {
        if (this.requests.replaced(request, 'seed')) return
        this.seed = seed
        this.again('anew', request)
      },
    )
  }

  // The robot's drive, or the arm's motion, along the result

  beginDrive = async (): Promise<void> => this.follow(await this.followers.robot(this.api))

  follow = async (follower: Follower): Promise<void> => {
    this.resumes = this.playing
    this.unfolded = false
    if (this.playing) this.pause()
    this.inspect(null)
    await follower.begin()
  }

  /** Back to the run as it was. */
  leaveDrive = (): void => {
    this.followers.leave()
    if (this.resumes) this.play()
    this.resumes = false
  }

  /** Nobody follows the result, and no iteration is unfolded. */
  protected stopPlayback(): void {
    this.followers.leave()
    this.unfolded = false
  }

  /** Shows this iteration step by step. */
  unfold = (): void => {
    this.followers.leave()
    if (this.playing) this.pause()
    this.inspect(null)
    this.unfolded = true
  }

  fold = (): void => {
    this.unfolded = false
  }
}

export const lab = new Lab()
