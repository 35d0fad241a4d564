import type { ParameterValue, Planner, Scene } from 'forage'
import { race as text } from '../i18n/race.en'
import { applies } from '../state/applicable'
import { lab } from '../state/lab.svelte'
import { sameScene } from '../state/same'
import { stopsOf, suits } from '../state/stops'
import { stillness } from '../state/theme.svelte'
import { views } from '../state/views.svelte'
import type { Size, View } from '../stage/view'
import { Lane } from './lane.svelte'
import { extent, onwards } from './notches'
import type { Entry, Ready } from './ready'
import type { Side } from './space'
import { ranks } from './standings'

export const [FEWEST, MOST] = [2, 4]
/** How long a stretch without a picture lasts at most, in milliseconds. */
const STRETCH = 60
/** After a pause of the machine it goes on from here instead of catching up. */
const LATE = 200
/** What is drawn needs its time, too. */
const LEAST = 12

const wait = (milliseconds: number): Promise<void> => new Promise((resolve) => setTimeout(resolve, milliseconds))

/** Whether a planner can race on a scene. */
export const fits = (planner: Planner, scene: Scene): boolean => suits(planner, scene) && stopsOf(scene).length <= (planner.stops ? (planner.most_stops ?? Infinity) : Infinity)

/** Planners beside each other on the same scene and seed. There is one clock, in evaluations. */
class Race {
  scene = $state.raw<Scene | null>(null)
  seed = $state(1)
  lanes = $state.raw<readonly Lane[]>([])
  /** Something that was done for the user and must be said. */
  notice = $state('')

  clock = $state(0)
  /** Where a seek is on its way to. */
  goal = $state<number | null>(null)
  playing = $state(false)
  starting = $state(false)
  /** Notches a second. */
  speed = $state(10)
  /** Evaluations of a notch, if they were chosen. */
  chosen = $state<number | null>(null)

  /** All lanes are seen alike. */
  view = $state.raw<View | null>(null)
  size = $state.raw<Size>({ width: 1, height: 1 })
  side = $state<Side>('corner')

  readonly racing = $derived(this.lanes.filter(({ racing }) => racing))
  /** A step is a planner's smallest move: a notch is the largest step of all, unless it was chosen. */
  readonly usual = $derived(Math.max(1, ...this.racing.map(({ run, picture }) => picture?.furthest.most ?? run?.most ?? 1)))
  readonly notch = $derived(this.chosen ?? this.usual)
  readonly begin = $derived(this.racing.length > 0 ? Math.min(...this.racing.map(({ run }) => run?.first ?? 0)) : 0)
  readonly extent = $derived(extent(this.clock, this.racing.map(({ end }) => end)))
  readonly over = $derived(this.racing.length > 0 && this.racing.every(({ over }) => over))
  readonly busy = $derived(this.playing || this.goal !== null || this.starting)
  readonly ranks = $derived(ranks(this.lanes.map(({ racing, mark }) => (racing ? mark : null))))
  /** Everything stands still, and all that there is to tell was told. */
  readonly still = $derived(!this.busy && this.racing.length > 0 && this.racing.every(({ settled }) => settled !== null))
  readonly planners = $derived<readonly Planner[]>(lab.catalogue?.planners.filter((planner) => this.scene && fits(planner, this.scene)) ?? [])

  private looping = false
  /** When the next picture is due. */
  private due = 0
  /** Notches that take about as long as a stretch may. */
  private stretch = 1
  /** How far the clock has come. */
  private known = 0
  private turns = 0

  /** The first time it takes up what the lab has. */
  async open(): Promise<void> {
    if (this.scene || !lab.scene) return
    const { plannerName: planner, params } = lab
    await this.set(lab.scene, lab.seed, this.rivals(lab.scene, { planner, params }))
  }

  /** The lab's planner and those of its family; whoever is there, where it has none. */
  private rivals(scene: Scene, own: Entry): Entry[] {
    const all = lab.catalogue?.planners.filter((planner) => fits(planner, scene)) ?? []
    const first = all.find(({ name }) => name === own.planner)
    const others = all.filter(({ name }) => name !== own.planner)
    const kin = others.filter(({ family }) => family === first?.family)
    const strangers = others.filter(({ family }) => family !== first?.family)
    const entries = [...kin, ...strangers].map(({ name }): Entry => ({ planner: name, params: {} }))
    return [...(first ? [own] : []), ...entries].slice(0, kin.length > 0 ? Math.min(kin.length + 1, MOST) : FEWEST)
  }

  /** A race of these planners, from its beginning. */
  private async set(scene: Scene, seed: number, entries: readonly Entry[]): Promise<void> {
    this.stop()
    for (const lane of this.lanes) lane.dismiss()
    this.lanes = entries.map(({ planner, params }) => new Lane(planner, params))
    this.place(scene)
    this.seed = seed
    this.chosen = null
    await this.restart()
  }

  private place(scene: Scene): void {
    if (!this.scene || !sameScene(scene, this.scene)) this.view = null
    this.scene = scene
  }

  openReady = async ({ scene, planners, seed, speed }: Ready): Promise<void> => {
    this.speed = speed
    await this.startOn(scene, seed, planners.map((planner) => ({ planner, params: {} })))
  }

  /** A race on a scene that ships, which goes off at once. */
  startOn = async (name: string, seed: number, entries: readonly Entry[]): Promise<void> => {
    const scene = lab.catalogue?.scenes.find((candidate) => candidate.name === name)
    if (!scene) return
    this.notice = ''
    await this.set(scene, seed, entries)
    if (!stillness.matches) this.play()
  }

  // What races where

  /** Whoever doesn't run there makes room. */
  setScene = async (scene: Scene): Promise<void> => {
    const fitting = lab.catalogue?.planners.filter((planner) => fits(planner, scene)) ?? []
    const staying = this.lanes.filter(({ planner }) => fitting.some(({ name }) => name === planner))
    const leaving = this.lanes.filter((lane) => !staying.includes(lane))
    const added = fitting.filter(({ name }) => !staying.some(({ planner }) => planner === name)).slice(0, Math.max(0, FEWEST - staying.length))
    for (const lane of leaving) lane.dismiss()
    this.lanes = [...staying, ...added.map(({ name }) => new Lane(name))]
    const title = (name: string): string => lab.catalogue?.planners.find((planner) => planner.name === name)?.title ?? name
    this.notice = leaving.length > 0 ? text.left(leaving.map(({ planner }) => title(planner)), added.map((planner) => planner.title), scene.title) : ''
    this.place(scene)
    await this.restart()
  }

  setSeed = (seed: number): Promise<void> => {
    this.seed = seed
    return this.restart()
  }

  add = async (): Promise<void> => {
    const next = this.planners.find(({ name }) => !this.lanes.some(({ planner }) => planner === name)) ?? this.planners[0]
    if (!next || this.lanes.length >= MOST) return
    const lane = new Lane(next.name)
    this.lanes = [...this.lanes, lane]
    await this.enter(lane)
  }

  remove = (lane: Lane): void => {
    if (this.lanes.length <= FEWEST) return
    lane.dismiss()
    this.lanes = this.lanes.filter((other) => other !== lane)
  }

  setPlanner = async (lane: Lane, planner: string): Promise<void> => {
    Object.assign(lane, { planner, params: planner === lab.plannerName ? lab.params : {}, errors: {} })
    await this.enter(lane)
  }

  setParameter = async (lane: Lane, name: string, value: ParameterValue | string): Promise<void> => {
    const params = { ...lane.params, [name]: value as ParameterValue }
    const { [name]: _gone, ...errors } = lane.errors
    lane.errors = errors
    if (await this.enter(lane, params)) lane.params = params
  }

  resetParameter = async (lane: Lane, name?: string): Promise<void> => {
    const drop = <T>(values: Record<string, T>): Record<string, T> => Object.fromEntries(Object.entries(values).filter(([key]) => name !== undefined && key !== name))
    lane.errors = drop(lane.errors)
    lane.params = drop(lane.params)
    await this.enter(lane)
  }

  /** What of these parameters means something here. */
  private applicable(lane: Lane, values: Record<string, ParameterValue>): Record<string, ParameterValue> {
    const planner = this.planners.find(({ name }) => name === lane.planner)
    const { scene } = this
    if (!planner || !scene) return {}
    return Object.fromEntries(
      Object.entries(values).filter(([key]) => planner.parameters.some((parameter) => parameter.name === key && applies(parameter, planner.parameters, scene.kind, values))),
    )
  }

  /** A racer begins anew and goes where the others are. */
  enter = async (lane: Lane, params = lane.params): Promise<boolean> => {
    const { scene, seed, turns } = this
    if (!scene) return false
    const accepted = await lane.start(scene, this.applicable(lane, params), seed)
    if (accepted && turns === this.turns) {
      // While the race goes on it catches up with the next notch.
      if (!this.busy) this.goal = this.clock
      void this.loop()
    }
    return accepted
  }

  /** All begin anew. */
  private async restart(): Promise<void> {
    const { scene, seed } = this
    const turn = (this.turns += 1)
    this.stop()
    if (!scene) return
    this.starting = true
    await Promise.all(this.lanes.map((lane) => lane.start(scene, this.applicable(lane, lane.params), seed)))
    if (turn !== this.turns) return
    this.starting = false
    this.known = 0
    this.stretch = 1
    this.clock = this.begin
    this.seek(this.begin)
  }

  // Time

  toggle = (): void => (this.playing ? this.pause() : this.play())

  play = (): void => {
    this.goal = this.over ? this.begin : null
    this.playing = true
    void this.loop()
  }

  /** It stops at the next picture: all stand at the same time. */
  pause = (): void => this.stop()

  private stop(): void {
    this.playing = false
    this.goal = null
  }

  seek = (to: number): void => {
    this.playing = false
    this.goal = Math.max(to, this.begin)
    void this.loop()
  }

  /** Notches on or back. */
  stepBy = (notches: number): void => {
    const from = this.goal !== null && Number.isFinite(this.goal) ? this.goal : this.clock
    if (notches < 0) this.seek(from + notches * this.notch)
    else this.seek(this.onwards(from) + (notches - 1) * this.notch)
  }

  private onwards(from: number): number {
    const runners = this.racing.flatMap(({ picture, over }) => (picture ? [{ evaluations: picture.evaluations, over }] : []))
    return Math.max(onwards(from, this.notch, runners), from)
  }

  toEnd = (): void => this.seek(Infinity)

  private async loop(): Promise<void> {
    if (this.looping) return
    this.looping = true
    this.due = performance.now()
    try {
      for (let next = this.next(); next !== null; next = this.next()) {
        const began = performance.now()
        await this.arrive(next)
        const took = Math.max(performance.now() - began, 1)
        this.stretch = Math.max(1, this.stretch * Math.min(Math.max(STRETCH / took, 0.5), 2))
        await wait(Math.max(this.playing && this.goal === null ? this.due - performance.now() : 0, LEAST))
      }
    } finally {
      this.looping = false
    }
    await Promise.all(this.racing.map((lane) => lane.settle()))
  }

  /** The time that comes next; null where it is to stand. */
  private next(): number | null {
    if (this.starting || this.racing.length === 0) {
      this.stop()
      return null
    }
    if (this.goal !== null) return this.towards(this.goal)
    if (this.over) this.playing = false
    return this.playing ? this.onwards(this.clock) + (this.more() - 1) * this.notch : null
  }

  /** How many notches are due. */
  private more(): number {
    const now = performance.now()
    if (!Number.isFinite(this.speed) || now - this.due > LATE) this.due = now
    if (!Number.isFinite(this.speed)) return Math.floor(this.stretch)
    const notches = 1 + Math.floor(((now - this.due) * this.speed) / 1000)
    this.due += (notches * 1000) / this.speed
    return notches
  }

  /** Where nobody was yet, there are pictures on the way to a goal. */
  private towards(goal: number): number | null {
    const placed = this.racing.every(({ picture }) => picture !== null)
    if (!placed) return Math.min(goal, this.clock)
    if (goal < this.clock) return goal
    if (goal > this.clock && !this.over) return Math.min(goal, Math.max(this.known, this.clock + Math.floor(this.stretch) * this.notch))
    this.goal = null
    return this.playing ? this.next() : null
  }

  /** All go there; they are shown together. */
  private async arrive(clock: number): Promise<void> {
    const { turns, racing } = this
    const pictures = await Promise.all(racing.map((lane) => lane.go(clock)))
    const shown = turns === this.turns
    racing.forEach((lane, at) => {
      const picture = pictures[at]
      if (picture && shown) lane.show(picture)
    })
    if (!shown) return
    // Where all have come to their end, there is no time beyond.
    this.known = Math.max(this.known, clock)
    this.clock = this.over ? Math.min(clock, Math.max(this.begin, ...racing.map(({ picture }) => picture?.evaluations ?? 0))) : clock
  }

  /** Exactly this run, where it stands. */
  openInStage = async (lane: Lane): Promise<void> => {
    this.pause()
    await lane.settle()
    const link = lane.settled?.link
    if (!link) return
    views.current = 'stage'
    await lab.openLink(link)
  }
}

export const race = new Race()
