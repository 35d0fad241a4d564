import { sceneText } from '../../../text/scene-text'
import type { ParameterValue, Planner, Scene } from 'forage-lab'
import { compare as text } from '../../../locales/en/compare'
import type { Refusal } from '../../../engine/protocol'
import { Requests } from '../../../engine/requests'
import type { Maps, Values } from '../../../engine/trial.protocol'
import { sameScene } from '../../../scene/equality'
import { perLab } from '../../../stores/context.svelte'
import type { Lab } from '../../../stores/lab.svelte'
import type { ProposedComparison, Sight } from '../../../stores/proposed.svelte'
import { SIGHTS } from '../../../stores/proposed.svelte'
import { sceneIn } from '../address'
import { StatisticsWorker } from '../statistics/statistics-worker'
import { codeOf } from '../../../catalogue/own'
import { mayOpenAll } from '../../../stores/own-code'
import { CODES, planKeys, planOf } from './address'
import { applicable, type Budget, COUNT, type Entrant, freeSlot, MOST_ENTRANTS, type Plan, planFor } from './plan'
import { offered, type Preset } from './presets'
import { remember, remembered } from './remembered'
import { Spendings } from './spendings.svelte'
import { allowanceOf, type Standing, standingsOf } from './standing'
import { fitting, type Task, taskOf, tasksOn } from './tasks'

/** Planners of one family that a comparison begins with. */
const FIRST = 4
/** Requests about what is run on: a scene, or maps. */
const GROUND = 'ground'

/** The address that has these keys. */
const addressOf = (keys: ReadonlyMap<string, string>): string =>
  `#view=compare${[...keys].map(([key, value]) => `&${key}=${value}`).join('')}`

/** What is compared: planners, a scene, seeds and a budget. It is watched side by side, or run many times. */
export class Comparison {
  as = $state<Sight>('watch')
  scene = $state.raw<Scene | null>(null)
  /** Instead of the one scene: a random map for each seed. */
  maps = $state.raw<Maps | null>(null)
  entrants = $state.raw<readonly Entrant[]>([])
  /** What was taken out last, and where it was. */
  removed = $state.raw<{ entrant: Entrant; at: number } | null>(null)
  from = $state(1)
  count = $state<number>(COUNT.standard)
  budget = $state.raw<Budget>('first')
  /** What was typed and refused, by field. */
  drafts = $state.raw<Readonly<Record<string, string>>>({})
  /** Something that was done for the user, or went wrong, and must be said. */
  notice = $state('')
  /** What the core said to runs that it refused, by key. */
  refusals = $state.raw<Readonly<Record<string, string>>>({})

  /** What there is to do on scenes that leave a choice. */
  private chosen = $state<Task>('path')
  readonly worker = new StatisticsWorker()
  readonly spendings = new Spendings()
  /** Requests about the entrants' parameters, by slot and name. */
  private readonly requests = new Requests<string>()
  private readonly listeners = new Set<() => void>()

  constructor(private readonly lab: Lab) {}

  /** The codes of planners that somebody wrote. */
  private get codes(): string {
    const planners = this.lab.setup.catalogue?.planners ?? []
    return planners
      .filter(({ name }) => this.entrants.some(({ planner }) => planner === name))
      .map((planner) => codeOf(planner).code ?? '')
      .join()
  }
  /** Those that the plan was made with. */
  private ranWith = ''

  readonly tasks = $derived.by(() => (this.scene ? tasksOn(this.lab.setup.catalogue, this.scene) : []))
  readonly task = $derived.by<Task>(() => (this.tasks.includes(this.chosen) ? this.chosen : (this.tasks[0] ?? 'path')))
  readonly plan = $derived<Plan | null>(
    this.scene && {
      scene: this.scene,
      maps: this.maps,
      entrants: this.entrants,
      from: this.from,
      count: this.count,
      // An evaluation of a planner that tunes is a whole run: there it is no measure.
      budget: this.task === 'tuning' ? 'own' : this.budget,
    },
  )
  readonly suitable = $derived.by(() => (this.scene ? fitting(this.lab.setup.catalogue, this.scene, this.task) : []))
  private readonly known = $derived.by(() => this.plan && allowanceOf(this.plan, this.suitable, this.spendings))
  /** Evaluations at which runs are stopped; null: none are, or it is not known yet. */
  readonly allowance = $derived(this.known ?? null)
  readonly standings = $derived.by<Standing[]>(() => {
    const { plan, suitable, known: allowance, spendings, refusals } = this
    const { catalogue } = this.lab.setup
    return plan && catalogue ? standingsOf(plan, catalogue, { suitable, allowance, spendings, refusals }) : []
  })
  /** Those that are run, once their budget is known. */
  readonly active = $derived(this.standings.filter(({ trouble, ready }) => trouble === '' && ready))
  readonly runnable = $derived(this.standings.filter(({ trouble }) => trouble === ''))
  /** How long some of them run is not known yet. */
  readonly waiting = $derived(this.runnable.some(({ ready }) => !ready))
  readonly faulty = $derived(Object.keys(this.drafts).length > 0)

  onchange(listener: () => void): void {
    this.listeners.add(listener)
  }

  // How it begins

  /** Begins with the plan of before a reload, or with what is in the lab: its planner as it is set up, and others of its family. What a newcomer is shown is too small to be compared. */
  begin(): void {
    const { catalogue } = this.lab.setup
    const { present } = this.lab.scene
    if (this.scene && !this.opening && this.codes !== this.ranWith) this.changed()
    if (this.scene || this.opening || !catalogue || !present) return
    const before = remembered(catalogue)
    const [ready] = offered(catalogue)
    if (before) Object.assign(this, before)
    else if (ready && this.lab.setup.isStandard) {
      void this.open(ready)
      return
    } else this.take(present, this.lab.setup.plannerName, this.lab.setup.seed)
    this.settleTask()
    this.changed()
  }

  private take(scene: Scene, planner: string, seed: number): void {
    const own = this.lab.setup.catalogue?.planners.find(({ name }) => name === planner)
    if (own) this.chosen = taskOf(own)
    this.scene = scene
    this.from = seed
    this.entrants = this.rivals(own)
  }

  /** A planner and those of its family; another planner, where it has none. */
  private rivals(own: Planner | undefined): Entrant[] {
    const { scene, suitable } = this
    const first = suitable.find((planner) => planner === own) ?? suitable[0]
    const others = suitable.filter((planner) => planner !== first)
    const kin = others.filter(({ family }) => family === first?.family)
    const all = [first, ...(kin.length > 0 ? kin.slice(0, FIRST - 1) : others.slice(0, 1))]
    return all.flatMap((planner, slot) =>
      planner && scene
        ? [{ slot, planner: planner.name, params: planner === own ? applicable(planner, scene, this.lab.parameters.values) : {} }]
        : [],
    )
  }

  /** As the first does that can be run. */
  private settleTask(): void {
    const first = this.entrants.map(({ planner }) => this.lab.setup.catalogue?.planners.find(({ name }) => name === planner))[0]
    if (first) this.chosen = taskOf(first)
  }

  open = async (preset: Preset): Promise<boolean> => {
    const { budget = 'first' } = preset
    const plan = {
      entrants: preset.entrants.map(({ planner, params = {} }) => ({ planner, params })),
      from: 1,
      count: preset.count,
      budget,
    }
    if ('maps' in preset) {
      const refused = await this.scatter(preset.maps, plan)
      return refused === null && this.maps === preset.maps
    }
    return this.set(preset.scene, plan)
  }

  /** What another room proposes becomes the plan. */
  propose = ({ as, scene, planners, seeds, budget = 'own', adds = false }: ProposedComparison): void => {
    this.as = as
    const [first] = planners
    // The planners that it is compared with stay.
    if (adds && first && scene === this.scene && this.entrants.some(({ planner }) => planner === first.planner)) {
      this.entrants = this.entrants.map((entrant) => (entrant.planner === first.planner ? { ...entrant, params: first.params } : entrant))
      this.changed()
      return
    }
    this.set(scene, { entrants: planners, ...seeds, budget })
  }

  private set(name: string | Scene, plan: { entrants: Preset['entrants']; from: number; count: number; budget: Budget }): boolean {
    const scene = typeof name === 'object' ? name : this.lab.setup.catalogue?.scenes.find((shipped) => shipped.name === name)
    if (!scene) return false
    this.requests.note(GROUND)
    this.scene = scene
    this.maps = null
    this.enter(plan)
    return true
  }

  private enter(plan: { entrants: Preset['entrants']; from: number; count: number; budget: Budget }): void {
    this.notice = ''
    this.removed = null
    this.entrants = plan.entrants.map(({ planner, params = {}, scene }, slot) => ({ slot, planner, params, ...(scene && { scene }) }))
    this.requests.note(...this.entrants.map(({ slot }) => `${slot}`))
    this.from = plan.from
    this.count = plan.count
    this.budget = plan.budget
    this.drafts = {}
    this.settleTask()
    this.changed()
  }

  /** An address is being read. */
  private opening = false

  /** What an address names becomes the plan. What the core does not take is left out, and said. */
  openAddress = async (keys: ReadonlyMap<string, string>): Promise<void> => {
    const { catalogue: before } = this.lab.setup
    if (!before) return
    const request = this.requests.note(GROUND)
    this.as = SIGHTS.find((sight) => sight === keys.get('as')) ?? this.as
    const { api, own } = this.lab
    const codes = keys.get(CODES)?.split(',') ?? []
    const read = async (): Promise<Awaited<ReturnType<typeof planOf>>> => {
      const allowed = await mayOpenAll(own, codes.slice(0, MOST_ENTRANTS), addressOf(keys))
      if (!allowed.ok) return { plan: null, wrong: [allowed.refusal.message] }
      if (allowed.value) {
        // Its codes are to be seen first.
        if (!this.requests.replaced(request, GROUND)) own.bring(allowed.value)
        return { plan: null, wrong: [] }
      }
      const catalogue = this.lab.setup.catalogue ?? before
      return planOf(keys, { catalogue, api, map: (maps, seed) => this.worker.map(maps, seed) })
    }
    this.opening = true
    const { plan, wrong } = await read()
      .catch((error: unknown) => ({ plan: null, wrong: [error instanceof Error ? error.message : String(error)] }))
      .finally(() => {
        this.opening = false
      })
    if (this.requests.replaced(request, GROUND)) return
    if (plan) {
      this.scene = plan.scene
      this.maps = plan.maps
      this.enter(plan)
    } else {
      this.begin()
    }
    this.notice = wrong.length > 0 ? text.address(wrong.join(' ')) : ''
  }

  /** The plan as keys of its address; null where its scene is not packed yet. */
  readonly keys = $derived.by<string | null>(() => {
    const { plan, packed } = this
    const { catalogue } = this.lab.setup
    return plan && catalogue && planKeys(plan, catalogue, (scene) => packed.find((known) => known.scene === scene)?.text ?? null)
  })
  private packed = $state.raw<readonly { scene: Scene; text: string }[]>([])

  /** Has the core pack scenes that do not ship: one is the lab's, or a run on it has a link. */
  packScenes = async (link: (scene: Scene) => Promise<string | undefined>): Promise<void> => {
    const { scene: common, entrants, packed } = this
    const scenes = [common, ...entrants.map(({ scene }) => scene)]
    for (const scene of scenes) {
      if (!scene || packed.some((known) => known.scene === scene)) continue
      const answer = this.lab.scene.present === scene ? await this.lab.api.link() : null
      const text = sceneIn((answer?.ok && answer.value) || ((await link(scene)) ?? ''))
      if (text) this.packed = [...this.packed.filter((known) => scenes.includes(known.scene)), { scene, text }]
    }
  }

  // What is changed

  choose = (scene: Scene): void => {
    this.requests.note(GROUND)
    if (!this.maps && sameScene(scene, this.scene)) return
    this.scene = scene
    this.maps = null
    this.join()
    this.notice = ''
    // Where none of them runs, others come; those wait for a scene on which they do.
    if (this.entrants.length > 0 && this.runnable.length === 0) {
      const room = MOST_ENTRANTS - this.entrants.length
      for (const { planner, params } of this.rivals(undefined).slice(0, room))
        this.entrants = [...this.entrants, { slot: this.vacant(), planner, params }]
      if (room > 0) this.notice = text.joined(sceneText(scene.title))
    }
    this.changed()
  }

  /** All run on the same scene. */
  private join(): void {
    this.entrants = this.entrants.map(({ scene: _own, ...entrant }) => entrant)
    if (this.removed) {
      const { scene: _own, ...entrant } = this.removed.entrant
      this.removed = { ...this.removed, entrant }
    }
  }

  /** Others do it. */
  setTask = (task: Task): void => {
    this.chosen = task
    this.removed = null
    this.entrants = this.rivals(undefined)
    this.changed()
  }

  /** A random map for each seed; what the generator refuses. */
  scatter = async (maps: Maps, plan?: Parameters<Comparison['enter']>[0]): Promise<Refusal | null> => {
    const request = this.requests.note(GROUND)
    try {
      const made = await this.worker.map(maps, plan?.from ?? this.from)
      if (this.requests.replaced(request, GROUND)) return null
      if (!made.scene) return made.refused ?? null
      this.scene = made.scene
      this.maps = maps
      this.join()
      if (plan) this.enter(plan)
      else this.changed()
    } catch (error) {
      this.notice = text.broken(error instanceof Error ? error.message : String(error))
    }
    return null
  }

  add = (planner: string): void => {
    if (this.entrants.length >= MOST_ENTRANTS) return
    const slot = this.vacant()
    const own = planner === this.lab.setup.plannerName && !this.entrants.some((entrant) => entrant.planner === planner)
    this.entrants = [...this.entrants, { slot, planner, params: own && !this.lab.setup.isStandard ? this.lab.parameters.values : {} }]
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
    this.removed = { entrant, at: this.entrants.indexOf(entrant) }
    this.entrants = this.entrants.filter((other) => other !== entrant)
    this.changed()
  }

  /** What was taken out last is where it was, with its parameters. */
  restore = (): void => {
    const { removed } = this
    if (!removed || this.entrants.length >= MOST_ENTRANTS) return
    const slot = this.entrants.some((other) => other.slot === removed.entrant.slot) ? this.vacant() : removed.entrant.slot
    this.entrants = this.entrants.toSpliced(removed.at, 0, { ...removed.entrant, slot })
    this.removed = null
    this.changed()
  }

  private setParams(slot: number, params: Values): void {
    this.entrants = this.entrants.map((entrant) => (entrant.slot === slot ? { ...entrant, params } : entrant))
    this.changed()
  }

  /** A field's number; text that was refused is kept. */
  type = (field: 'from' | 'count' | 'budget', typed: { value: number | null } | { refused: string }): void => {
    const { [field]: _gone, ...others } = this.drafts
    if ('refused' in typed) {
      this.drafts = { ...others, [field]: typed.refused }
      return
    }
    this.drafts = others
    if (field === 'budget') this.budget = typed.value ?? 'first'
    else if (typed.value !== null) this[field] = typed.value
    this.changed()
  }

  setEqual = (equal: boolean): void => {
    const { budget: _gone, ...others } = this.drafts
    this.drafts = others
    this.budget = equal ? 'first' : 'own'
    this.changed()
  }

  /** Back to the default of one parameter, or of all. */
  reset = (slot: number, name?: string): void => {
    const { [name ?? '']: _dropped, ...rest } = this.entrants.find((entrant) => entrant.slot === slot)?.params ?? {}
    this.requests.note(name === undefined ? `${slot}` : `${slot} ${name}`)
    this.setParams(slot, name === undefined ? {} : rest)
  }

  /** Asks the core about an entrant's parameter before it is set: its message, or nothing. */
  try = async (slot: number, name: string, value: ParameterValue | string): Promise<string> => {
    const { plan } = this
    const entrant = this.entrants.find((candidate) => candidate.slot === slot)
    const planner = plan && entrant && this.lab.setup.catalogue?.planners.find((candidate) => candidate.name === entrant.planner)
    if (!plan || !entrant || !planner) return ''
    const request = this.requests.note()
    const { scene } = planFor(entrant, plan)
    const params = applicable(planner, scene, { ...entrant.params, [name]: value })
    try {
      const refusal = await this.worker.check({ planner: planner.name, scene, params, seed: 1, ...codeOf(planner), full: false })
      if (this.requests.replaced(request, `${slot} ${name}`, `${slot}`)) return ''
      if (refusal?.field === name) return refusal.message
    } catch (error) {
      return text.broken(error instanceof Error ? error.message : String(error))
    }
    // Others may have been set meanwhile.
    const present = this.entrants.find((candidate) => candidate.slot === slot)
    if (present) this.setParams(slot, { ...present.params, [name]: value })
    return ''
  }

  private changed(): void {
    this.ranWith = this.codes
    const { catalogue } = this.lab.setup
    if (this.plan && catalogue) remember(this.plan, catalogue)
    this.tell()
    this.ask()
  }

  /** Asks what the entrants spend, where that decides how long they run. */
  private ask(): void {
    const wanted = this.plan?.budget === 'own' ? [] : this.standings.flatMap(({ spending }) => spending ?? [])
    this.spendings.ask(wanted, () => {
      this.tell()
      this.ask()
    })
  }

  private tell(): void {
    for (const listener of this.listeners) listener()
  }
}

export const comparisonOf = perLab((lab) => new Comparison(lab))
