import type { ParameterValue, Planner, Scene } from 'forage-lab'
import { race as text } from '../../../locales/en/race'
import { meaningful, standardOn } from '../../../catalogue/parameters'
import { perLab } from '../../../stores/context.svelte'
import type { Lab } from '../../../stores/lab.svelte'
import type { ProposedRace } from '../../../stores/proposed.svelte'
import { sameScene } from '../../../scene/equality'
import { stillness } from '../../../stores/theme.svelte'
import { route } from '../../../stores/route.svelte'
import type { Size, View } from '../../../render/view'
import { contendersText, named, sceneIn, shippedText, wholeIn } from '../address'
import { Lane, type Started } from './lane.svelte'
import type { Entry, Ready } from './presets'
import { fitting, type Task, taskOf, tasksOn } from './tasks'
import { Times } from './times.svelte'
import type { Side } from '../../../render/space/orbit'
import { ranks } from './standings'

const without = <T>(values: Record<string, T>, name: string): Record<string, T> =>
  Object.fromEntries(Object.entries(values).filter(([key]) => key !== name))

export const [FEWEST, MOST] = [2, 4]
/** Planners beside each other on the same scene and seed. There is one clock, in evaluations. */
export class Race extends Times {
  scene = $state.raw<Scene | null>(null)
  seed = $state(1)
  /** What all of them are to do; scenes with stops and ends leave a choice. */
  task = $state<Task>('path')
  /** Something that was done for the user and must be said. */
  notice = $state('')

  /** All lanes are seen alike. */
  view = $state.raw<View | null>(null)
  size = $state.raw<Size>({ width: 1, height: 1 })
  side = $state<Side>('corner')

  readonly ranks = $derived(ranks(this.lanes.map(({ racing, mark }) => (racing ? mark : null))))
  readonly planners = $derived.by<readonly Planner[]>(() => (this.scene ? fitting(this.lab.setup.catalogue, this.scene, this.task) : []))

  constructor(private readonly lab: Lab) {
    super()
  }

  /** The first time it takes up what the lab has. */
  async open(): Promise<void> {
    if (this.scene || this.opening || !this.lab.scene.present) return
    const { plannerName: planner } = this.lab.setup
    const { values: params } = this.lab.parameters
    const own = this.lab.setup.catalogue?.planners.find(({ name }) => name === planner)
    const task =
      own && tasksOn(this.lab.setup.catalogue, this.lab.scene.present).includes(taskOf(own))
        ? taskOf(own)
        : this.taskOn(this.lab.scene.present)
    await this.set(this.lab.scene.present, this.lab.setup.seed, this.rivals(this.lab.scene.present, { planner, params }, task), task)
  }

  /** The lab's planner and those of its family; whoever is there, where it has none. */
  private rivals(scene: Scene, own: Entry, task: Task): Entry[] {
    const all = fitting(this.lab.setup.catalogue, scene, task)
    const first = all.find(({ name }) => name === own.planner) ?? all[0]
    const others = all.filter((planner) => planner !== first)
    const kin = others.filter(({ family }) => family === first?.family)
    const strangers = others.filter(({ family }) => family !== first?.family)
    return [first, ...kin, ...strangers]
      .slice(0, kin.length > 0 ? Math.min(kin.length + 1, MOST) : FEWEST)
      .flatMap((planner) => (planner ? [{ planner: planner.name, params: planner.name === own.planner ? own.params : {} }] : []))
  }

  /** A race of these planners, from its beginning; false if another one has taken its place. */
  private async set(scene: Scene, seed: number, entries: readonly Entry[], task: Task): Promise<boolean> {
    this.stop()
    this.task = task
    for (const lane of this.lanes) lane.dismiss()
    this.lanes = entries.map(({ planner, params }) => new Lane(this.lab.setup, planner, params))
    this.place(scene)
    this.seed = seed
    this.chosen = null
    return this.restart()
  }

  private place(scene: Scene): void {
    if (!this.scene || !sameScene(scene, this.scene)) this.view = null
    this.scene = scene
  }

  openReady = async ({ scene: name, planners, seed, speed }: Ready): Promise<void> => {
    const scene = this.lab.setup.catalogue?.scenes.find((candidate) => candidate.name === name)
    if (!scene) return
    this.notice = ''
    this.speed = speed
    const first = this.lab.setup.catalogue?.planners.find((planner) => planner.name === planners[0])
    const begun = await this.set(
      scene,
      seed,
      planners.map((planner) => ({ planner, params: {} })),
      first ? taskOf(first) : this.task,
    )
    if (begun && !stillness.matches) this.play()
  }

  /** What another view proposes stands at its start. */
  propose = async ({ scene: name, planners, seed }: ProposedRace): Promise<void> => {
    const scene = this.lab.setup.catalogue?.scenes.find((candidate) => candidate.name === name)
    if (!scene) return
    this.notice = ''
    const first = this.lab.setup.catalogue?.planners.find((planner) => planner.name === planners[0]?.planner)
    await this.set(scene, seed, planners, first ? taskOf(first) : this.task)
  }

  /** An address is being read. */
  private opening = false

  /** What an address names, where it stood. What the core does not take is left out, and said. */
  openAddress = async (keys: ReadonlyMap<string, string>): Promise<void> => {
    this.opening = true
    const found = await named(this.lab.api, keys.get('scene') ?? '', keys.get('with') ?? '')
      .catch((error: unknown) => ({ refused: [error instanceof Error ? error.message : String(error)] }))
      .finally(() => {
        this.opening = false
      })
    this.notice = found.refused.length > 0 ? text.address(found.refused.join(' ')) : ''
    const { planners = [] } = this.lab.setup.catalogue ?? {}
    const first = 'contenders' in found ? planners.find(({ name }) => name === found.contenders[0]?.planner) : undefined
    if (!('contenders' in found) || !first) {
      await this.open()
      return
    }
    const task = taskOf(first)
    const able = fitting(this.lab.setup.catalogue, found.scene, task)
    const runs = ({ planner }: Entry): boolean => able.some(({ name }) => name === planner)
    const entries = found.contenders.filter(runs).slice(0, MOST)
    const left = found.contenders.filter((entry) => !entries.includes(entry))
    if (left.length > 0) {
      const titles = left.map(({ planner }) => planners.find(({ name }) => name === planner)?.title ?? planner)
      this.notice = [this.notice, text.left(titles, [], found.scene.title)].filter(Boolean).join(' ')
    }
    const seed = wholeIn(keys.get('seed'), 0, Number.MAX_SAFE_INTEGER) ?? 1
    const at = wholeIn(keys.get('at'), 0, Number.MAX_SAFE_INTEGER)
    const begun = await this.set(found.scene, seed, entries, task)
    if (begun && at !== null) this.seek(at)
  }

  /** How it stands, as keys of an address; null before that is known. */
  readonly keys = $derived.by<string | null>(() => {
    const { scene, seed, lanes, clock, sceneText, lab } = this
    const named =
      scene && lab.setup.catalogue && (shippedText(lab.setup.catalogue, scene) ?? (sceneText?.of === scene ? sceneText.text : null))
    return named ? `&scene=${named}&seed=${seed}&with=${contendersText(lanes)}&at=${clock}` : null
  })
  /** The scene as the core packs it, where it does not ship. */
  private sceneText = $state.raw<{ of: Scene; text: string } | null>(null)

  /** Has the core pack a scene that does not ship, once a run on it stands. */
  packScene = async (): Promise<void> => {
    const { scene, sceneText, lab } = this
    const lane = this.racing[0]
    if (!scene || !lane || sceneText?.of === scene || !lab.setup.catalogue || shippedText(lab.setup.catalogue, scene)) return
    const link = await lane.link()
    const packed = link.ok ? sceneIn(link.value) : null
    if (packed && this.scene === scene) this.sceneText = { of: scene, text: packed }
  }

  // What races where

  /** Whoever doesn't run there makes room. */
  setScene = async (scene: Scene): Promise<void> => {
    const task = this.taskOn(scene)
    const able = fitting(this.lab.setup.catalogue, scene, task)
    const staying = this.lanes.filter(({ planner }) => able.some(({ name }) => name === planner))
    const leaving = this.lanes.filter((lane) => !staying.includes(lane))
    const added = able.filter(({ name }) => !staying.some(({ planner }) => planner === name)).slice(0, Math.max(0, FEWEST - staying.length))
    for (const lane of leaving) lane.dismiss()
    this.lanes = [...staying, ...added.map(({ name }) => new Lane(this.lab.setup, name))]
    const title = (name: string): string => this.lab.setup.catalogue?.planners.find((planner) => planner.name === name)?.title ?? name
    this.notice =
      leaving.length > 0
        ? text.left(
            leaving.map(({ planner }) => title(planner)),
            added.map((planner) => planner.title),
            scene.title,
          )
        : ''
    this.place(scene)
    this.task = task
    await this.restart()
  }

  /** As before, where that can be done there. */
  private taskOn(scene: Scene): Task {
    const tasks = tasksOn(this.lab.setup.catalogue, scene)
    return tasks.includes(this.task) ? this.task : (tasks[0] ?? 'path')
  }

  /** Ways and tours can't be compared: others race. */
  setTask = async (task: Task): Promise<void> => {
    const { scene } = this
    if (scene && task !== this.task) await this.set(scene, this.seed, this.rivals(scene, { planner: '', params: {} }, task), task)
  }

  setSeed = async (seed: number): Promise<void> => {
    this.seed = seed
    await this.restart()
  }

  add = async (): Promise<void> => {
    const next = this.planners.find(({ name }) => !this.lanes.some(({ planner }) => planner === name)) ?? this.planners[0]
    if (!next || this.lanes.length >= MOST) return
    const lane = new Lane(this.lab.setup, next.name)
    this.lanes = [...this.lanes, lane]
    await this.enter(lane)
  }

  remove = (lane: Lane): void => {
    if (this.lanes.length <= FEWEST) return
    lane.dismiss()
    this.lanes = this.lanes.filter((other) => other !== lane)
  }

  setPlanner = async (lane: Lane, planner: string): Promise<void> => {
    const params = planner === this.lab.setup.plannerName ? this.lab.parameters.values : {}
    Object.assign(lane, { planner, params, wanted: params, errors: {} })
    await this.enter(lane)
  }

  setParameter = (lane: Lane, name: string, value: ParameterValue | string): Promise<void> => {
    lane.errors = without(lane.errors, name)
    lane.wanted = { ...lane.wanted, [name]: value as ParameterValue }
    return this.tryWanted(lane)
  }

  /** Begins with what is wanted at once: a start that takes long gives way to it. What is refused takes no other change with it. */
  private async tryWanted(lane: Lane): Promise<void> {
    const { wanted } = lane
    const isNewest = (): boolean => lane.wanted === wanted && this.lanes.includes(lane)
    let started = await this.enter(lane, wanted)
    // A race that began again meanwhile knew nothing of this change.
    while (started === 'overtaken' && isNewest()) started = await this.enter(lane, wanted)
    if (!isNewest()) return
    if (started === 'begun') {
      lane.params = this.changed(lane, wanted)
      lane.wanted = lane.params
      return
    }
    const [kept, before] = [wanted, lane.params].map((values) => Object.entries(values))
    const refused = ([name]: [string, ParameterValue]): boolean => name in lane.errors
    lane.wanted = Object.fromEntries([...(kept ?? []).filter((entry) => !refused(entry)), ...(before ?? []).filter(refused)])
    const again = Object.keys(lane.errors).some((name) => lane.wanted[name] !== wanted[name]) && this.differs(lane)
    if (again) await this.tryWanted(lane)
    else lane.wanted = lane.params
  }

  /** More is wanted than what was taken over. */
  private differs({ wanted, params }: Lane): boolean {
    return Object.keys({ ...wanted, ...params }).some((name) => wanted[name] !== params[name])
  }

  /** What differs from the defaults. */
  private changed(lane: Lane, values: Record<string, ParameterValue>): Record<string, ParameterValue> {
    const { scene } = this
    const known = this.planners.find(({ name }) => name === lane.planner)?.parameters ?? []
    const standard = (name: string): ParameterValue | undefined =>
      known.flatMap((parameter) => (parameter.name === name && scene ? [standardOn(parameter, scene.kind)] : []))[0]
    return Object.fromEntries(Object.entries(values).filter(([name, value]) => value !== standard(name)))
  }

  resetParameter = async (lane: Lane, name?: string): Promise<void> => {
    const rest = <T>(values: Record<string, T>): Record<string, T> => (name === undefined ? {} : without(values, name))
    lane.errors = rest(lane.errors)
    lane.params = rest(lane.params)
    lane.wanted = rest(lane.wanted)
    if (this.differs(lane)) await this.tryWanted(lane)
    else await this.enter(lane)
  }

  /** What of these parameters means something here. */
  private applicable(lane: Lane, values: Record<string, ParameterValue>): Record<string, ParameterValue> {
    const planner = this.planners.find(({ name }) => name === lane.planner)
    const { scene } = this
    return planner && scene ? meaningful(planner, scene, values) : {}
  }

  /** A racer begins anew and goes where the others are. */
  enter = async (lane: Lane, params = lane.params): Promise<Started> => {
    const { scene, seed, turns } = this
    if (!scene) return 'refused'
    const started = await lane.start(scene, this.applicable(lane, params), seed)
    if (started === 'begun' && turns === this.turns) this.gather()
    return started
  }

  /** All begin again; false if they have begun once more meanwhile. */
  private async restart(): Promise<boolean> {
    const { scene, seed } = this
    this.turns += 1
    const turn = this.turns
    this.stop()
    if (!scene) return false
    this.starting = true
    await Promise.all(this.lanes.map((lane) => lane.start(scene, this.applicable(lane, lane.params), seed)))
    if (turn !== this.turns) return false
    this.starting = false
    this.rewind()
    return true
  }

  /** Exactly this run, where it stands. */
  openInStage = async (lane: Lane): Promise<void> => {
    this.pause()
    const link = await lane.link()
    if (!link.ok) return
    route.go('stage')
    await this.lab.openLink(link.value)
  }
}

export const raceOf = perLab((lab) => new Race(lab))
