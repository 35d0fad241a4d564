import type { Catalogue, Inspection, Item, Layer, LinkSetup, Outcome, ParameterValue, Planner, Scene, Setup, Status, Suggestion } from 'forage'
import { en } from '../i18n/en'
import { number } from '../panels/format'
import type { FrameMessage, Opening, ProgressMessage, Refusal, Run } from '../worker/protocol'
import { address } from './address'
import { applies, met } from './applicable'
import { Client } from './client'
import type { Clock } from './clock.svelte'
import { Course } from './course.svelte'
import { Followers } from './followers.svelte'
import type { Follower } from './following.svelte'
import { type Again, Scenes } from './scenes.svelte'
import { stageAt } from './stages'
import { suits } from './stops'
import { stillness } from './theme.svelte'
import { views } from './views.svelte'

const FIRST = { planner: 'wcpso', scene: 'wcpso-discs', seed: 1 }

export type Tuned = NonNullable<Outcome['tuned']>
export type Phase = 'loading' | 'ready' | 'crashed'
/** Which optimum results are measured by. Only in a grid and of tours there is more than one. */
export type Yardstick = 'plain' | Outcome['exact_by']

/** Everything the page knows. Components read it and call its methods; nothing else holds state of the run. */
class Lab extends Scenes {
  phase = $state<Phase>('loading')
  crash = $state('')
  catalogue = $state.raw<Catalogue | null>(null)

  plannerName = $state(FIRST.planner)
  params = $state.raw<Record<string, ParameterValue>>({})
  seed = $state(FIRST.seed)

  run = $state.raw<Run | null>(null)
  frame = $state.raw<FrameMessage | null>(null)
  iteration = $state(0)
  computed = $state(0)
  status = $state<Status>('running')
  playing = $state(false)
  /** Where a seek is on its way to. */
  target = $state<number | null>(null)
  /** Of the runs of other planners that the next step needs. */
  private progress = $state.raw<ProgressMessage | null>(null)
  readings = $state.raw<Record<string, number>>({})
  outcome = $state.raw<Outcome | null>(null)
  hash = $state('')
  readonly course = new Course()

  inspection = $state.raw<Inspection | null>(null)
  /** The members' numbers, row by row, while somebody asks for them. */
  members = $state.raw<Float64Array | null>(null)
  private item: Item | null = null
  private tuner: Tuned | null = null
  hidden = $state.raw<Record<string, boolean>>({})
  speed = $state(30)

  /** The sizes that the planner's paper recommends. */
  suggestion = $state.raw<Suggestion | null>(null)
  sceneError = $state.raw<Refusal | null>(null)
  paramErrors = $state.raw<Record<string, string>>({})
  notice = $state('')
  /** A random map is being made. */
  making = $state(false)
  /** True from a change until its first picture: the old one must not pass for the new. */
  stale = $state(false)

  readonly planner = $derived<Planner | null>(this.catalogue?.planners.find(({ name }) => name === this.plannerName) ?? null)
  /** What is looked for is a tour through the stops: start and goal mean nothing. */
  readonly touring = $derived(this.scene?.kind === 'tour' || (this.grid !== null && (this.planner?.stops ?? false)))
  /** It tells what happens and what it decides. */
  readonly eventful = $derived((this.planner?.events.length ?? 0) > 0)
  /** It plans in an arm's joints, and tells of each node: its costs are angles. */
  readonly inJoints = $derived(this.planner?.members.some(({ name }) => name === 'q1') ?? false)
  private readonly span = $derived(this.course.of(this.run))
  readonly limit = $derived(this.span.limit)
  readonly stages = $derived(this.span.stages)
  readonly yardstick = $derived<Yardstick>((this.grid || this.touring) && this.outcome ? this.outcome.exact_by : 'plain')
  /** The optimum that results are measured by, in words. */
  readonly optimum = $derived(this.arm ? en.result.tip : en.result[this.planner?.stops ? 'tours' : 'optimum'][this.yardstick])
  /** The part of the run that it is in, and how far in it. */
  readonly part = $derived(stageAt(this.stages, this.iteration))
  /** How far a step is that takes its time. */
  readonly underway = $derived(this.progress?.generation === this.run?.generation ? this.progress : null)
  /** What is done before there can be a result: how many of the roads between the stops stand. In the end, what kept it from one. */
  readonly building = $derived.by(() => {
    if (this.eventful && this.finished) return this.outcome?.trouble ?? ''
    const { roads } = this.readings
    const stops = this.grid?.stops?.length ?? 0
    if (!this.planner?.stops || roads === undefined || this.outcome?.order) return ''
    if (this.finished) return this.outcome?.trouble ?? ''
    return en.result.roads(number(roads), number((stops * (stops - 1)) / 2))
  })
  readonly finished = $derived(this.status !== 'running')

  private readonly client = new Client({
    onframe: (frame) => this.receive(frame),
    onprogress: (progress) => (this.progress = progress.total > 0 ? progress : null),
    oncrash: (message) => this.breakDown(message),
  })
  readonly followers = new Followers()
  /** An iteration is shown step by step. */
  unfolded = $state(false)
  /** A time beside that of the run that the stage's keys are for, and the way back. */
  beside = $state.raw<{ clock: Clock; leave(): void } | null>(null)
  /** There is a path of this very scene to follow. */
  readonly followable = $derived(this.outcome?.length != null && !this.stale && !this.sceneError && this.target === null)
  readonly drivable = $derived(this.hasRobot && this.followable)
  /** The fingerprint that an opened link promises, and where. */
  private promised: { hash: string; at: number } | undefined
  private asked = ''
  private starting = false
  /** The run was going on when the robot set off. */
  private resumes = false
  private pending: Opening | null = null
  /** What the run was last asked to begin with. */
  private opened: Opening = { at: 0, play: false }

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
    if (this.scene) {
      await this.restart({ at: this.iteration, play: false })
      return
    }
    this.put(this.shipped(FIRST.scene), false)
    const opened = location.hash.length > 1 && !views.named(location.hash) && (await this.openLink(location.hash))
    if (!opened) await this.restart({ at: 0, play: views.current === 'stage' && !stillness.matches })
  }

  /** Starts a new thread after a crash, with what the user had made. */
  recover = (): Promise<void> => this.open()

  private shipped(name: string): Scene {
    const scenes = this.catalogue?.scenes ?? []
    const scene = scenes.find((candidate) => candidate.name === name) ?? scenes[0]
    if (!scene) throw new Error('no scene ships')
    return scene
  }

  openLink = async (link: string): Promise<boolean> => {
    const answer = await this.client.api.parseLink(link)
    if (!answer.ok) {
      this.notice = en.notices.link(answer.refusal.message)
      return false
    }
    const { planner, scene, params, seed, iteration, hash }: LinkSetup = answer.value
    this.plannerName = planner
    // A page that opens on a link has nothing to go back to.
    this.put(scene, this.run !== null)
    this.params = params
    this.paramErrors = {}
    this.seed = seed
    this.promised = hash === undefined ? undefined : { hash, at: iteration }
    this.notice = ''
    await this.restart({ at: iteration, play: false })
    return true
  }

  /** Starts the run anew. One request is on its way at a time; of those that come meanwhile the newest counts. */
  private async restart(opening: Opening): Promise<void> {
    this.stand()
    this.pending = this.opened = opening
    this.stale = true
    if (this.starting) return
    this.starting = true
    try {
      while (this.pending) {
        const next: Opening = this.pending
        this.pending = null
        await this.begin(next)
      }
    } finally {
      this.starting = false
      // The first picture may have come before the answer.
      if (!this.sceneError && this.frame && this.frame.generation === this.run?.generation) this.stale = false
    }
  }

  private async begin(opening: Opening): Promise<void> {
    const { scene } = this
    if (!scene || this.phase !== 'ready') return
    const setup: Setup = { planner: this.plannerName, scene, params: this.applicable(), seed: this.seed }
    const answer = await this.client.api.start(setup, opening)
    if (!answer.ok) {
      this.refuse(answer.refusal)
      return
    }
    void this.ask(setup)
    this.run = answer.value
    this.sceneError = null
    this.hash = ''
    this.playing = opening.play
    this.target = opening.at > 0 ? opening.at : null
    this.inspection = null
    this.item = null
  }

  /** The recommendation hangs on the planner and its parameters; cells that are painted don't change it. */
  private async ask(setup: Setup): Promise<void> {
    const key = JSON.stringify([setup.planner, this.scene?.kind, setup.params])
    if (key === this.asked) return
    this.asked = key
    const answer = await this.client.api.suggest(setup)
    if (this.asked === key) this.suggestion = answer.ok ? answer.value : null
  }

  /** What of these parameters means something here. The rest waits for a planner, a scene and values with which it does. */
  private applicable(values = this.params): Record<string, ParameterValue> {
    const { planner, scene } = this
    if (!planner || !scene) return {}
    const known = planner.parameters.filter((parameter) => applies(parameter, planner.parameters, scene.kind, values))
    return Object.fromEntries(Object.entries(values).filter(([key]) => known.some(({ name }) => name === key)))
  }

  /** The layers that there can be with these parameters. */
  readonly layers = $derived<Layer[]>(
    this.planner?.layers.filter(({ when, kinds }) => this.planner && this.scene && (kinds?.includes(this.scene.kind) ?? true) && met(when, this.planner.parameters, this.scene.kind, this.params)) ?? [],
  )

  private refuse(refusal: Refusal): void {
    if (this.planner?.parameters.some(({ name }) => name === refusal.field)) {
      this.paramErrors = { ...this.paramErrors, [refusal.field]: refusal.message }
      // What runs is still the run of before.
      this.stale = false
    } else {
      this.sceneError = refusal
    }
  }

  private breakDown(message: string): void {
    this.phase = 'crashed'
    this.stand()
    this.crash = message
    this.playing = false
    this.target = null
    this.progress = null
    // What that thread was asked will never be answered.
    this.starting = false
    this.pending = null
    this.client.close()
  }

  private receive(frame: FrameMessage): void {
    const previous = this.frame
    if (previous) this.client.giveBack(previous.buffer)
    previous?.fields.forEach(({ bitmap }) => bitmap.close())
    const anew = frame.generation !== previous?.generation
    this.frame = frame
    this.course.receive(frame, anew)
    this.iteration = frame.iteration
    this.computed = frame.computed
    this.status = frame.status
    this.readings = frame.readings
    this.inspection = frame.inspection
    if (frame.members || anew) this.members = frame.members
    if (this.run?.generation === frame.generation && !this.starting && !this.sceneError) this.stale = false
    if (frame.report) this.hear(frame, frame.report)
    else this.hash = ''
  }

  private hear(frame: FrameMessage, report: NonNullable<FrameMessage['report']>): void {
    this.outcome = report.outcome
    this.hash = report.settledHash ?? ''
    if (report.settledHash === null) {
      address.soon(report.link)
      return
    }
    this.playing = frame.playing
    this.target = null
    this.progress = null
    this.followers.heed(frame)
    address.now(report.link)
    if (this.promised?.at === frame.iteration) {
      if (this.promised.hash !== report.settledHash) this.notice = en.notices.hash
      this.promised = undefined
    }
  }

  // Transport

  toggle = (): void => (this.playing ? this.pause() : this.play())

  play = (): void => {
    this.stand()
    this.playing = true
    this.target = null
    void this.client.api.play()
  }

  pause = (): void => {
    this.playing = false
    this.progress = null
    void this.client.api.pause()
  }

  seek = (to: number): void => {
    const iteration = Math.min(Math.max(Math.round(to), 0), this.limit)
    this.followers.leave()
    this.playing = false
    this.target = iteration
    void this.client.api.seek(iteration)
  }

  stepBy = (n: number): void => this.seek((this.target ?? this.iteration) + n)

  setSpeed = (speed: number): void => {
    this.speed = speed
    void this.client.api.speed(speed)
  }

  // What is planned with what

  protected again(where: Again = 'anew'): void {
    this.promised = undefined
    const { scene, planner } = this
    // An edit that leaves the planner too little is refused, and undone: nothing takes its place.
    const another = scene?.kind !== this.run?.scene.kind || scene?.name !== this.run?.scene.name
    if (scene && planner && another && !suits(planner, scene)) this.suit(scene)
    const at = where === 'here' && !this.finished ? (this.stale ? this.opened.at : (this.target ?? this.iteration)) : 0
    void this.restart(where === 'on' ? this.opened : { at, play: this.playing || !this.run || (this.finished && !stillness.matches) })
  }

  setPlanner = (name: string): void => {
    const planner = this.catalogue?.planners.find((candidate) => candidate.name === name)
    if (!planner || name === this.plannerName) return
    this.paramErrors = {}
    if (this.tuner?.planner === name) this.params = this.tuner.params
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
    this.params = params
    this.seed = seed
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

  /** Scenes and maps, each of one file or of two that belong together. */
  importFiles = async (files: Iterable<File>): Promise<void> => (await import('./imports')).importFiles([...files])

  /** Runs the planner that was tuned, with what the tuning came to. The tuner's own parameters wait for its return. */
  useTuned = ({ planner, params }: Tuned): void => {
    this.tuner = { planner: this.plannerName, params: this.params }
    this.paramErrors = {}
    this.plannerName = planner
    this.params = params
    this.again()
  }

  setSeed = (seed: number): void => {
    this.seed = seed
    this.again()
  }

  newSeed = async (): Promise<void> => this.setSeed(await this.client.api.newSeed())

  setParameter = async (name: string, value: ParameterValue | string): Promise<void> => {
    const { scene, plannerName } = this
    if (!scene) return
    const params = this.applicable({ ...this.params, [name]: value as ParameterValue })
    // Whoever is asked for sizes checks the whole setup.
    const answer = await this.client.api.suggest({ planner: plannerName, scene, params, seed: this.seed })
    if (!answer.ok && answer.refusal.field === name) {
      this.paramErrors = { ...this.paramErrors, [name]: answer.refusal.message }
      return
    }
    this.forgive(name)
    this.params = { ...this.params, [name]: value }
    this.again()
  }

  resetParameter = (name?: string): void => {
    const { [name ?? '']: _dropped, ...rest } = this.params
    this.params = name === undefined ? {} : rest
    if (name === undefined) this.paramErrors = {}
    else this.forgive(name)
    this.again()
  }

  /** Both sizes at once, and one new run. */
  useSuggestion = ({ population, iterations }: Suggestion): void => {
    this.forgive('population')
    this.forgive('iterations')
    this.params = { ...this.params, population, iterations }
    this.again()
  }

  private forgive(name: string): void {
    const { [name]: _gone, ...rest } = this.paramErrors
    this.paramErrors = rest
  }

  // The robot's drive, or the arm's motion, along the result

  beginDrive = async (): Promise<void> => this.follow(await this.followers.robot(this.client))

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
  private stand(): void {
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

  // Looking closer

  pick = async (x: number, y: number, reach: number): Promise<void> => this.inspect(await this.client.api.pick(x, y, reach))

  inspect = (item: Item | null): void => {
    this.item = item
    if (!item) this.inspection = null
    void this.client.api.watch(item)
  }

  get inspecting(): boolean {
    return this.item !== null
  }

  /** What is looked at closer, also before there is an answer. */
  get wanted(): Item | null {
    return this.item
  }

  shows = (role: string, standard: boolean): boolean => !(this.hidden[role] ?? !standard)

  showLayer = (role: string, on: boolean): void => {
    this.hidden = { ...this.hidden, [role]: !on }
  }

  get api(): Client['api'] {
    return this.client.api
  }
}

export const lab = new Lab()
