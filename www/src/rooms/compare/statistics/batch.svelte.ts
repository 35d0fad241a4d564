import type { Catalogue, ParameterValue, Planner, Scene } from 'forage-lab'
import { batch as text } from '../../../locales/en/batch'
import { canRun } from '../../../catalogue/suitability'
import { perLab } from '../../../stores/context.svelte'
import type { Lab } from '../../../stores/lab.svelte'
import type { ProposedBatch } from '../../../stores/proposed.svelte'
import { Requests } from '../../../engine/requests'
import { sameScene } from '../../../scene/equality'
import type { Refusal } from '../../../engine/protocol'
import type { Ending, Errand, Maps, Row } from '../../../engine/trial.protocol'
import { Trials } from '../../../engine/trials'
import { StatisticsWorker } from './statistics-worker'
import {
  type Entrant,
  applicable,
  COUNT,
  freeSlot,
  keyOf,
  labels,
  groundOf,
  MOST_ENTRANTS,
  paramsOf,
  type Plan,
  runnerOf,
} from '../plan/plan'
import { sceneIn } from '../address'
import { planKeys, planOf } from '../plan/address'
import type { Ready } from './presets'
import { ComputedRows } from './computed-rows.svelte'
import { remember, remembered } from './remembered'
import { inGaps, type Shown, shownOf } from './shown'
import { TestLooks } from './testlooks'

/** Without lots every seed gives the same run. */
const drawsLots = (rows: readonly Row[]): boolean => rows.length < 2 || rows.some(({ record }) => !record.deterministic)

/** An entrant as it stands in the plan. */
export interface Standing {
  entrant: Entrant
  label: string
  /** Absent where it doesn't run on the scene. */
  planner: Planner | undefined
  key: string
  /** Why it isn't run. */
  trouble: string
}

/** Other bits of the core may compute other rows: put there while building. */
declare const CORE_VERSION: string

/** How often the numbers on the way are told, in milliseconds. */
const TELLING = 120
/** Drawing many runs takes its time: it is done less often, in milliseconds. */
const [LEAST_PAUSE, MOST_PAUSE] = [250, 1500]
/** Planners of one family that a batch begins with. */
const FIRST = 4
/** Requests about what is run on: a scene, or maps. */
const GROUND = 'ground'
const wait = (milliseconds: number): Promise<void> => new Promise((resolve) => setTimeout(resolve, milliseconds))

/** Many runs: what is to be run, what came out, and whether it goes on. It goes on while other views are looked at. */
export class Batch {
  scene = $state.raw<Scene | null>(null)
  /** Instead of the one scene: a random map for each seed. */
  maps = $state.raw<Maps | null>(null)
  entrants = $state.raw<readonly Entrant[]>([])
  from = $state(1)
  count = $state<number>(COUNT.standard)
  iterations = $state<number | null>(null)
  /** What was typed and refused, by field. */
  drafts = $state.raw<Readonly<Record<string, string>>>({})

  running = $state(false)
  /** Something went wrong that is nobody's fault. */
  notice = $state('')
  /** What the core said to runs that it refused, by key. */
  private refusals = $state.raw<Readonly<Record<string, string>>>({})
  /** Seconds that the rest takes; null: not known. */
  left = $state<number | null>(null)
  /** What is drawn and tabled: of one moment, all of it. */
  shown = $state.raw<Shown | null>(null)
  /** Bumped when rows came. */
  private version = $state(0)

  private readonly statistics = new StatisticsWorker()
  readonly rows = new ComputedRows((key) => this.statistics.forget(key))
  /** Names of keys whose runs were begun: their plan may have been left when they end. */
  private readonly names = new Map<string, string>()
  private readonly begun = new Set<string>()
  private cursor = 0
  private stopping = false
  private since = { at: 0, done: 0 }
  private telling: ReturnType<typeof setTimeout> | undefined
  private readonly looks = new TestLooks()
  /** Requests about the entrants' parameters, by slot and name. */
  private readonly requests = new Requests<string>()
  private asking = false
  private askAgain = false
  private readonly trials = new Trials({
    next: () => this.next(),
    over: (errand, ending) => this.take(errand, ending),
    rested: () => this.rest(),
  })

  constructor(private readonly lab: Lab) {}

  readonly plan = $derived<Plan | null>(
    this.scene && {
      scene: this.scene,
      maps: this.maps,
      entrants: this.entrants,
      from: this.from,
      count: this.count,
      iterations: this.iterations,
    },
  )
  readonly standings = $derived.by<Standing[]>(() =>
    this.plan && this.lab.setup.catalogue ? this.stand(this.plan, this.lab.setup.catalogue) : [],
  )
  /** Those that are run. */
  readonly active = $derived(this.standings.filter(({ trouble }) => trouble === ''))
  readonly total = $derived(this.active.length * this.count)
  readonly done = $derived.by(() => {
    void this.version
    return this.active.reduce((sum, { key }) => sum + this.seeds.filter((seed) => this.rows.of(key)?.has(seed)).length, 0)
  })
  readonly seeds = $derived(Array.from({ length: this.count }, (_, at) => this.from + at))
  readonly faulty = $derived(Object.keys(this.drafts).length > 0)

  private stand(plan: Plan, { planners, generators }: Catalogue): Standing[] {
    const names = labels(plan, planners)
    const met = new Set<string>()
    return plan.entrants.map((entrant, at) => {
      const label = names[at] ?? entrant.planner
      const planner = runnerOf(entrant, plan.scene, planners)
      if (!planner) return { entrant, label, planner, key: '', trouble: text.entrants.unsuited(groundOf(plan, generators)) }
      const key = keyOf(planner, entrant, plan)
      const trouble = met.has(key) ? text.entrants.double : (this.refusals[key] ?? '')
      met.add(key)
      return { entrant, label, planner, key, trouble }
    })
  }

  /** Begins with the plan of before a reload, or with what is on the stage: its planner as it is set up, and others of its family. */
  begin(catalogue: Catalogue, scene: Scene): void {
    if (this.scene || this.opening) return
    const before = remembered(catalogue)
    if (before) {
      Object.assign(this, before)
      void this.restore()
      return
    }
    this.scene = scene
    const first = catalogue.planners.find(({ name }) => name === this.lab.setup.plannerName)
    const others = catalogue.planners.filter((planner) => planner.family === first?.family && planner !== first && canRun(planner, scene))
    this.entrants = [...(first && canRun(first, scene) ? [first] : []), ...others].slice(0, FIRST).map((planner, slot) => ({
      slot,
      planner: planner.name,
      params: planner === first ? applicable(planner, scene, this.lab.parameters.values) : {},
    }))
    void this.restore()
  }

  // The plan

  choose = (scene: Scene): void => {
    this.requests.note(GROUND)
    if (!this.maps && sameScene(scene, this.scene)) return
    this.scene = scene
    this.maps = null
    this.changed()
  }

  /** A random map for each seed; what the generator refuses. */
  scatter = async (maps: Maps): Promise<Refusal | null> => {
    const request = this.requests.note(GROUND)
    try {
      const made = await this.statistics.map(maps, this.from)
      if (this.requests.replaced(request, GROUND)) return null
      if (!made.scene) return made.refused ?? null
      this.scene = made.scene
      this.maps = maps
      this.changed()
    } catch (error) {
      this.notice = text.run.broken(error instanceof Error ? error.message : String(error))
    }
    return null
  }

  add = (planner: string, params: Entrant['params'] = {}): void => {
    if (this.entrants.length >= MOST_ENTRANTS) return
    const slot = this.vacant()
    const own = planner === this.lab.setup.plannerName && !this.entrants.some((entrant) => entrant.planner === planner)
    this.entrants = [...this.entrants, { slot, planner, params: own ? this.lab.parameters.values : params }]
    this.changed()
  }

  copy = (entrant: Entrant): void => {
    if (this.entrants.length >= MOST_ENTRANTS) return
    const at = this.entrants.indexOf(entrant) + 1
    this.entrants = this.entrants.toSpliced(at, 0, { ...entrant, slot: this.vacant() })
    this.changed()
  }

  /** A free slot. Answers about the entrant that had it before no longer count. */
  private vacant(): number {
    const slot = freeSlot(this.entrants)
    this.requests.note(`${slot}`)
    return slot
  }

  remove = (entrant: Entrant): void => {
    this.entrants = this.entrants.filter((other) => other !== entrant)
    this.changed()
  }

  private set(slot: number, params: Entrant['params']): void {
    this.entrants = this.entrants.map((entrant) => (entrant.slot === slot ? { ...entrant, params } : entrant))
    this.changed()
  }

  /** A field's number; text that was refused is kept. */
  type = (field: 'from' | 'count' | 'iterations', typed: { value: number | null } | { refused: string }): void => {
    const { [field]: _gone, ...others } = this.drafts
    if ('refused' in typed) {
      this.drafts = { ...others, [field]: typed.refused }
      return
    }
    this.drafts = others
    if (field === 'iterations') this.iterations = typed.value
    else if (typed.value !== null) this[field] = typed.value
    this.changed()
  }

  /** Back to the default of one parameter, or of all. */
  reset = (slot: number, name?: string): void => {
    const { [name ?? '']: _dropped, ...rest } = this.entrants.find((entrant) => entrant.slot === slot)?.params ?? {}
    this.requests.note(name === undefined ? `${slot}` : `${slot} ${name}`)
    this.set(slot, name === undefined ? {} : rest)
  }

  /** Asks the core about an entrant's parameter before it is set: its message, or nothing. */
  try = async (slot: number, name: string, value: ParameterValue | string): Promise<string> => {
    const { plan } = this
    const entrant = this.entrants.find((candidate) => candidate.slot === slot)
    const planner = plan && entrant && this.lab.setup.catalogue?.planners.find((candidate) => candidate.name === entrant.planner)
    if (!plan || !entrant || !planner) return ''
    const request = this.requests.note()
    const wanted = { ...entrant.params, [name]: value }
    const params = applicable(planner, plan.scene, wanted)
    try {
      const refusal = await this.statistics.check({ planner: planner.name, scene: plan.scene, params, seed: 1 })
      if (this.requests.replaced(request, `${slot} ${name}`, `${slot}`)) return ''
      if (refusal?.field === name) return refusal.message
    } catch (error) {
      return text.run.broken(error instanceof Error ? error.message : String(error))
    }
    // Others may have been set meanwhile.
    const present = this.entrants.find((candidate) => candidate.slot === slot)
    if (present) this.set(slot, { ...present.params, [name]: value })
    return ''
  }

  open = async (ready: Ready): Promise<void> => {
    if ('maps' in ready) {
      this.enter(ready.entrants, 1, ready.count)
      await this.scatter(ready.maps)
      if (this.maps !== ready.maps) return
    } else if (!this.plans(ready.scene, ready.entrants, 1, ready.count)) return
    this.run()
  }

  /** What another view proposes becomes the plan; how long it takes is seen before it is run. */
  propose = ({ scene, planners, seeds }: ProposedBatch): void => void this.plans(scene, planners, seeds.from, seeds.count)

  private plans(name: string, entrants: Ready['entrants'], from: number, count: number): boolean {
    const scene = this.lab.setup.catalogue?.scenes.find((shipped) => shipped.name === name)
    if (!scene) return false
    this.requests.note(GROUND)
    this.scene = scene
    this.maps = null
    this.enter(entrants, from, count)
    this.changed()
    return true
  }

  /** An address is being read. */
  private opening = false

  /** What an address names becomes the plan. What the core does not take is left out, and said. */
  openAddress = async (keys: ReadonlyMap<string, string>): Promise<void> => {
    const { catalogue } = this.lab.setup
    if (!catalogue) return
    const request = this.requests.note(GROUND)
    const { api } = this.lab
    this.opening = true
    const { plan, wrong } = await planOf(keys, { catalogue, api, map: (maps, seed) => this.statistics.map(maps, seed) })
      .catch((error: unknown) => ({ plan: null, wrong: [error instanceof Error ? error.message : String(error)] }))
      .finally(() => {
        this.opening = false
      })
    if (this.requests.replaced(request, GROUND)) return
    this.notice = wrong.length > 0 ? text.run.address(wrong.join(' ')) : ''
    if (plan) {
      this.requests.note(...plan.entrants.map(({ slot }) => `${slot}`))
      Object.assign(this, plan, { drafts: {} })
      this.changed()
    } else if (this.lab.scene.present) {
      this.begin(catalogue, this.lab.scene.present)
    }
  }

  /** The plan as keys of its address; null where its scene is not packed yet. */
  readonly keys = $derived.by<string | null>(() => {
    const { plan, packed } = this
    const { catalogue } = this.lab.setup
    return plan && catalogue && planKeys(plan, catalogue, packed?.scene === plan.scene ? packed.text : null)
  })
  private packed = $state.raw<{ scene: Scene; text: string } | null>(null)

  /** Has the core pack a scene that does not ship: it is the lab's, or a run of the plan tells of it. */
  packScene = async (): Promise<void> => {
    const { scene } = this
    if (!scene || this.packed?.scene === scene) return
    const [row] = this.active.flatMap(({ key }) => [...(this.rows.of(key)?.values() ?? [])])
    const answer = this.lab.scene.present === scene ? await this.lab.api.link() : null
    const text = sceneIn((answer?.ok && answer.value) || (row?.link ?? ''))
    if (text) this.packed = { scene, text }
  }

  private enter(entrants: Ready['entrants'], from: number, count: number): void {
    this.entrants = entrants.map(({ planner, params = {} }, slot) => ({ slot, planner, params }))
    this.requests.note(...this.entrants.map(({ slot }) => `${slot}`))
    this.from = from
    this.count = count
    this.iterations = null
    this.drafts = {}
  }

  /** The rows that still apply stay; while it runs, what is missing is run next. */
  private changed(): void {
    this.cursor = 0
    this.since = { at: performance.now(), done: this.done }
    this.left = null
    if (this.running && !this.stopping) {
      this.recall()
      this.trials.start()
    }
    if (this.plan && this.lab.setup.catalogue) remember(this.plan, this.lab.setup.catalogue)
    void this.restore()
    void this.refresh()
  }

  // The runs

  run = (): void => {
    this.notice = ''
    this.refusals = {}
    this.running = true
    this.stopping = false
    this.cursor = 0
    this.since = { at: performance.now(), done: this.done }
    this.rows.guard(this.running)
    if (this.plan && this.lab.setup.catalogue) remember(this.plan, this.lab.setup.catalogue)
    this.trials.start()
  }

  stop = (): void => {
    this.stopping = true
    this.trials.stop()
  }

  /** Long runs of a plan that was left would hold up those that are wanted. */
  private recall(): void {
    const keys = new Set(this.active.map(({ key }) => key))
    this.trials.recall(({ key, seed }) => keys.has(key) && seed >= this.from && seed < this.from + this.count)
  }

  private next(): Errand | null {
    const { plan, active } = this
    if (!plan) return null
    while (this.cursor < active.length * plan.count) {
      const { planner, entrant, key } = active[this.cursor % active.length] ?? {}
      const seed = plan.from + Math.floor(this.cursor / active.length)
      this.cursor += 1
      const id = `${key} ${seed}`
      if (!planner || !entrant || key === undefined || this.rows.of(key)?.has(seed) || this.begun.has(id)) continue
      this.begun.add(id)
      this.names.set(key, this.nameOf(key))
      const setup = { planner: planner.name, scene: plan.scene, params: paramsOf(planner, entrant, plan), seed }
      return { key, seed, setup, maps: plan.maps }
    }
    return null
  }

  private take({ key, seed }: Errand, ending: Ending): void {
    this.begun.delete(`${key} ${seed}`)
    if (ending.is === 'over') {
      this.rows.add({ key, name: this.names.get(key) ?? key }, seed, ending.row)
      this.rows.forgetBut(this.active.map((standing) => standing.key))
      this.telling ??= setTimeout(() => this.tell(), TELLING)
    } else if (ending.is === 'refused') {
      this.refusals = { ...this.refusals, [key]: ending.refusal.message }
      this.cursor = 0
    } else if (ending.is === 'stopped') {
      // It may be wanted again by now.
      this.cursor = 0
    } else {
      this.notice = text.run.broken(ending.message)
    }
  }

  /** What the rows of a key have in common, whatever page they were computed in: the core, planner, ground and parameters. */
  private nameOf(key: string): string {
    const { plan } = this
    const { planner, entrant } = this.standings.find((candidate) => candidate.key === key) ?? {}
    const params = plan && planner && entrant && paramsOf(planner, entrant, plan)
    return JSON.stringify([CORE_VERSION, planner?.name, plan?.maps ?? plan?.scene, params])
  }

  /** Takes in what the browser keeps of this plan. */
  private async restore(): Promise<void> {
    if (await this.rows.restore(this.active.map(({ key }) => ({ key, name: this.nameOf(key) })))) this.tell()
  }

  /** Deletes all rows, also those that the browser keeps of other plans. */
  deleteRows = async (): Promise<void> => {
    await this.rows.clear()
    this.tell()
    this.rows.guard(this.running)
  }

  private tell(): void {
    clearTimeout(this.telling)
    this.telling = undefined
    this.version += 1
    const fresh = this.done - this.since.done
    const rate = fresh / (performance.now() - this.since.at)
    this.left = fresh > 2 && rate > 0 ? (this.total - this.done) / rate / 1000 : null
    void this.refresh()
  }

  private rest(): void {
    this.tell()
    this.running = false
    this.left = null
    this.rows.guard(this.running)
  }

  /** These results are in a file now. */
  saved = ({ groups }: Shown): void => {
    this.rows.saved(groups.flatMap(({ rows }) => rows))
    this.rows.guard(this.running)
  }

  /** Has the present rows summed up; one question is on its way at a time. */
  private async refresh(): Promise<void> {
    this.askAgain = true
    if (this.asking) return
    this.asking = true
    try {
      while (this.askAgain) {
        this.askAgain = false
        await this.ask()
        if (this.running)
          await wait(Math.min(MOST_PAUSE, LEAST_PAUSE + (this.shown?.groups ?? []).reduce((sum, { rows }) => sum + rows.length, 0) / 3))
      }
    } catch (error) {
      this.notice = text.run.broken(error instanceof Error ? error.message : String(error))
    } finally {
      this.asking = false
    }
  }

  private async ask(): Promise<void> {
    const { plan } = this
    if (!plan) return
    const groups = this.active
      .map(({ entrant, label, key, planner }) => ({
        slot: entrant.slot,
        label,
        key,
        planner: entrant.planner,
        params: planner ? paramsOf(planner, entrant, plan) : {},
        rows: this.seeds.flatMap((seed) => this.rows.of(key)?.get(seed) ?? []),
      }))
      .filter(({ rows }) => rows.length > 0)
      .map((group) => ({ ...group, lots: drawsLots(group.rows) }))
    if (groups.length === 0) {
      this.shown = null
      return
    }
    const relative = inGaps(plan, groups)
    const answer = await this.statistics.summarise(groups, relative)
    this.shown = shownOf(plan, groups, answer, this.looks.at(plan, groups), relative)
  }
}

export const batchOf = perLab((lab) => new Batch(lab))
