import type { Catalogue, Layer, LinkSetup, Look, Outcome, ParameterValue, Planner, Scene, UncheckedSetup, Status, When } from 'forage-lab'
import { en } from '../locales/en/page'
import type { Picture, Progress, Refusal, Report, Run } from '../engine/protocol'
import { RunClient } from '../engine/run-client'
import { type Anchors, anchorsOf } from '../render/anchors'
import { Outlet } from '../render/outlet'
import { layersOf, meaningful, met } from '../catalogue/parameters'
import type { Clock } from './clock.svelte'
import { readCatalogue } from './catalogue'
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
import { type Opening, worded } from './transport.svelte'
import { type Camera, type PageKeys, readPageKeys } from './page-keys'
import { route } from './route.svelte'
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
  /** Its frame is the renderer's. */
  report = $state.raw<Report | null>(null)
  /** What the stage shows of the plane; null: all of the scene. */
  camera = $state.raw<Camera | null>(null)
  /** What a link wants it to show, until it does. */
  wantedCamera = $state.raw<Camera | null>(null)
  /** What of the newest frame can be pointed at. */
  anchors = $state.raw<Anchors | null>(null)
  readonly frames = new Outlet(
    (buffer) => this.client.giveBack(buffer),
    () => void this.client.want({}),
  )
  /** The first picture is on the screen: what it did not need may come. */
  drawn = $state(false)
  computed = $state(0)
  status = $state<Status>('running')
  readings = $state.raw<Record<string, number>>({})
  outcome = $state.raw<Outcome | null>(null)
  readonly course = new Course()

  /** The members' numbers, row by row, while somebody asks for them. */
  members = $state.raw<Float64Array | null>(null)
  private tuner: Tuned | null = null
  readonly visible = new Visible()
  readonly suggested = new Suggested()
  sceneError = $state.raw<Refusal | null>(null)
  unloaded = $state.raw<Unloaded | null>(null)
  private readonly startAgain = async (): Promise<void> => void this.restart(this.requested)
  /** The newest run did not start: what runs is the run of before. */
  readonly failed = $derived(this.sceneError !== null || this.unloaded?.ask === this.startAgain)
  notice = $state('')
  /** A random map is being made. */
  making = $state(false)
  readonly planner = $derived<Planner | null>(this.catalogue?.planners.find(({ name }) => name === this.plannerName) ?? null)
  /** The planner that drew the frame: another one may have been chosen. */
  private readonly drawer = $derived(this.catalogue?.planners.find(({ name }) => name === this.report?.planner))
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
  readonly finished = $derived(this.status !== 'running')
  /** What is done before there can be a result: how many of the roads between the stops stand. */
  readonly building = $derived(missing(this.planner, this.grid, this.readings, this.outcome, this.finished))

  private opened = false
  protected readonly client = new RunClient({
    onopen: () => this.receiveOpen(),
    onreport: (report) => this.receive(report),
    onpicture: (picture) => this.pass(picture),
    onaccepted: (version) => this.takeParameters(version),
    onrefused: (refusal, version) => this.refuse(worded(refusal), version),
    onprogress: (progress) => this.receiveProgress(progress),
    onbroken: (message) => this.breakDown(message),
    onreplaced: () => this.leaveThread('loading'),
  })
  readonly followers = new Followers()
  /** An iteration is shown step by step. */
  unfolded = $state(false)
  /** A time beside that of the run that the stage's keys are for, and the way back. */
  beside = $state.raw<{ clock: Clock; leave(): void } | null>(null)
  readonly stale = $derived(this.restarting || this.failed || this.awaited.length > 0)
  /** There is a path of this very scene to follow. */
  readonly followable = $derived(this.outcome?.length != null && !this.stale && !this.failed && this.target === null)
  readonly drivable = $derived(this.hasRobot && this.followable)
  /** The fingerprint that an opened link promises, and where. */
  private promised: { hash: string; at: number } | undefined
  /** The run was going on when the robot set off. */
  private resumes = false

  /** Once more, after a part could not be loaded. */
  retry = async (): Promise<void> => {
    const { unloaded } = this
    await unloaded?.ask()
    // Otherwise it has failed again.
    if (this.unloaded === unloaded) this.unloaded = null
  }

  /** Starts a thread. After a crash it begins with what the user had made. */
  async open(): Promise<void> {
    this.crash = ''
    this.phase = 'loading'
    void this.client.open()
    if (!this.catalogue) {
      try {
        this.catalogue = await readCatalogue()
      } catch (error) {
        this.breakDown(error instanceof Error ? error.message : String(error))
        return
      }
      if (this.opened) this.phase = 'ready'
      this.put(this.shipped(FIRST.scene), false)
    }
    // Nothing was wanted before it broke down.
    if (!this.client.desired.start) await this.openFirst()
  }

  /** The run of the address, or the one that the page begins with. */
  private async openFirst(): Promise<void> {
    const opened = route.first !== null && (await this.openLink(route.first))
    if (!opened) this.restart({ at: 0, play: route.view === 'stage' && !stillness.matches })
  }

  /** The thread is there. */
  private receiveOpen(): void {
    this.opened = true
    if (this.catalogue) this.phase = 'ready'
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
    const request = this.requests.note('setup', 'seed')
    let opened = true
    await this.await(
      async () => this.api.parseLink(link),
      (answer) => {
        opened = answer.ok
        if (!answer.ok) this.warn(answer.refusal, en.notices.link(answer.refusal.message), () => this.openLink(link))
        else if (!this.requests.replaced(request, 'setup')) {
          this.openSetup(answer.value, request)
          this.applyPageKeys(readPageKeys(link))
        }
      },
    )
    return opened
  }

  private openSetup({ planner, scene, params, seed, iteration, hash }: LinkSetup, request: number): void {
    this.plannerName = planner
    // A page that opens on a link has nothing to go back to.
    this.put(scene, this.run !== null)
    this.replaceParameters(params)
    this.seed = seed
    this.promised = hash === undefined ? undefined : { hash, at: iteration }
    this.notice = ''
    this.restart({ at: iteration, play: false }, request)
  }

  private applyPageKeys({ item, camera, layers }: PageKeys): void {
    this.visible.chosen = { ...this.visible.chosen, ...layers }
    this.wantedCamera = camera
    if (item && this.planner?.layers.some(({ role, pickable }) => role === item.role && pickable)) this.inspect(item)
  }

  /** Starts a new run; the number of that change, or 0 if there is no scene yet. */
  private restart(opening: Opening, since?: number): number {
    this.stopPlayback()
    const { scene } = this
    return scene ? this.start(this.setup(scene, this.wantedParameters), opening, since) : 0
  }

  protected setup(scene: Scene, values: Record<string, ParameterValue>): UncheckedSetup {
    const params = this.planner ? meaningful(this.planner, scene, values) : {}
    return { planner: this.plannerName, scene, params, seed: this.seed }
  }

  /** The run that was wanted is there. */
  private begin(run: Run): void {
    this.run = run
    this.sceneError = null
    if (this.unloaded?.ask === this.startAgain) this.unloaded = null
    this.takeParameters(run.generation)
    const { start } = this.client.desired
    if (start) void this.suggested.ask(this.api, start.setup, run.scene.kind)
  }

  /** How a layer of the frame, of an explanation or of the scene looks. */
  lookOf = (key: string): Look => layerOf(this.catalogue, this.drawer, key)?.look ?? PLAIN

  /** Whether a condition on the parameters is met. */
  met = (when: When | undefined): boolean =>
    Boolean(this.planner && this.scene && met(when, this.planner.parameters, this.scene.kind, this.params))

  /** The layers that there can be with these parameters. */
  readonly layers = $derived<Layer[]>(this.planner && this.scene ? layersOf(this.planner, this.scene.kind, this.params) : [])

  /** The run that change number `version` wanted is refused. */
  private refuse(refusal: Refusal, version: number): void {
    this.showHeading()
    if (refusal.unloaded) {
      this.sceneError = null
      this.warn(refusal, refusal.message, this.startAgain)
    } else if (this.planner?.parameters.some(({ name }) => name === refusal.field)) {
      // What else was wanted with a value that is taken back is still wanted.
      if (this.refuseParameter(refusal, version) && !this.client.starting && this.differs()) this.restart(this.requested)
    } else {
      this.sceneError = refusal
    }
  }

  /** Whether what is chosen is not what runs. */
  private differs(): boolean {
    const { scene } = this
    const present = this.client.desired.start?.setup
    if (!scene || !present) return true
    const { planner, seed, params } = this.setup(scene, this.wantedParameters)
    return (
      present.scene !== scene || JSON.stringify([planner, seed, params]) !== JSON.stringify([present.planner, present.seed, present.params])
    )
  }

  /** Says what was refused; where nothing was but a part could not be loaded, `ask` is offered. */
  warn(refusal: Refusal, message: string, ask: () => Promise<unknown>): void {
    if (refusal.unloaded) this.unloaded = { message, ask }
    else this.notice = message
  }

  private breakDown(message: string): void {
    this.crash = message
    this.leaveThread('crashed')
    this.forget()
  }

  /** Another thread goes on with what is wanted, at once or when the user says so. */
  private leaveThread(phase: 'crashed' | 'loading'): void {
    this.phase = phase
    this.opened = false
    this.stopPlayback()
    this.underway = null
    this.showHeading()
  }

  private receive(report: Report): void {
    this.report = report
    this.pass(report)
    if (report.run) this.begin(report.run)
    this.course.receive(report)
    this.computed = report.furthest.iteration
    this.status = report.status
    this.readings = report.readings
    this.inspection = report.inspection
    if (report.members || report.run) this.members = report.members
    this.showReport(report)
    if (report.outcome) this.outcome = report.outcome
    if (this.restarting || !this.client.follows(report)) return
    if (report.link !== null) route.write(report.link, report.hash === null ? 'soon' : 'now')
    if (report.hash === null) return
    this.underway = null
    this.followers.heed(report)
    this.compare(report)
  }

  private receiveProgress(progress: Progress | null): void {
    this.underway = progress?.generation === this.run?.generation ? progress : null
    // Pictures may be ahead of reports.
    if (this.underway) this.iteration = this.underway.step - 1
  }

  /** The frame goes to whom it is drawn by. */
  private pass({ frame }: Picture): void {
    const { names } = this
    if (!names) return
    this.anchors = anchorsOf(frame, names)
    this.frames.put(frame, names)
    // In other rooms nothing is drawn.
    if (!this.frames.connected) requestAnimationFrame(this.seen)
  }

  /** The first picture is on the screen. */
  readonly seen = (): void => {
    if (this.drawn) return
    performance.mark('first-picture')
    this.drawn = true
    this.client.want({ links: true })
  }

  /** Whether the run of a link is the one that the link promises. */
  private compare({ iteration, hash }: Report): void {
    if (this.promised?.at !== iteration) return
    if (this.promised.hash !== hash) this.notice = en.notices.hash
    this.promised = undefined
  }

  // What is planned with what

  protected again(where: Again = 'begin', since?: number): number {
    this.promised = undefined
    const { scene, planner } = this
    // An edit that leaves the planner too little is refused, and undone: nothing takes its place.
    const another = scene?.kind !== this.run?.scene.kind || scene?.name !== this.run?.scene.name
    if (scene && planner && another && !suits(planner, scene)) this.suit(scene)
    if (where === 'on' || (where === 'here' && this.restarting)) return this.restart(this.requested, since)
    const at = where === 'here' && !this.finished ? (this.target ?? this.iteration) : 0
    return this.restart({ at, play: this.playing || !this.run || (this.finished && !stillness.matches) }, since)
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
    this.restart({ at: 0, play: !stillness.matches })
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
        this.again('begin', request)
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
