import type { Scene } from 'forage-lab'
import { batch as text } from '../../../locales/en/batch'
import { codeOf, isOwn } from '../../../catalogue/own'
import { perLab } from '../../../stores/context.svelte'
import type { Lab } from '../../../stores/lab.svelte'
import type { Ending, Errand, Row } from '../../../engine/trial.protocol'
import { Trials } from '../../../engine/trials'
import { type Comparison, comparisonOf } from '../plan/comparison.svelte'
import { ComputedRows } from './computed-rows.svelte'
import { inGaps, type Shown, shownOf } from './shown'
import { TestLooks } from './testlooks'

/** Without lots every seed gives the same run. */
const drawsLots = (rows: readonly Row[]): boolean => rows.length < 2 || rows.some(({ record }) => !record.deterministic)

/** Other bits of the core may compute other rows: put there while building. */
declare const CORE_VERSION: string

/** How often the numbers on the way are told, in milliseconds. */
const TELLING = 120
/** Drawing many runs takes its time: it is done less often, in milliseconds. */
const [LEAST_PAUSE, MOST_PAUSE] = [250, 1500]
const wait = (milliseconds: number): Promise<void> => new Promise((resolve) => setTimeout(resolve, milliseconds))

/** Many runs of what is compared: what came out, and whether it goes on. It goes on while other rooms are looked at. */
export class Batch {
  running = $state(false)
  /** Something went wrong that is nobody's fault. */
  notice = $state('')
  /** Seconds that the rest takes; null: not known. */
  left = $state<number | null>(null)
  /** What is drawn and tabled: of one moment, all of it. */
  shown = $state.raw<Shown | null>(null)
  /** Bumped when rows came. */
  private version = $state(0)

  readonly rows = new ComputedRows((key) => this.comparison.worker.forget(key))
  /** Names of keys whose runs were begun: their plan may have been left when they end. */
  private readonly names = new Map<string, string>()
  private readonly begun = new Set<string>()
  private cursor = 0
  private stopping = false
  private since = { at: 0, done: 0 }
  private telling: ReturnType<typeof setTimeout> | undefined
  private readonly looks = new TestLooks()
  private asking = false
  private askAgain = false
  private readonly trials = new Trials({
    next: () => this.next(),
    over: (errand, ending) => this.take(errand, ending),
    rested: () => this.rest(),
  })

  constructor(private readonly comparison: Comparison) {
    comparison.onchange(() => this.changed())
  }

  readonly total = $derived.by(() => this.comparison.runnable.length * this.comparison.count)
  readonly seeds = $derived.by(() => Array.from({ length: this.comparison.count }, (_, at) => this.comparison.from + at))
  readonly done = $derived.by(() => {
    void this.version
    return this.comparison.active.reduce((sum, { key }) => sum + this.seeds.filter((seed) => this.rows.of(key)?.has(seed)).length, 0)
  })

  /** The link of a run of the plan, if there is one. */
  link = (scene: Scene): string | undefined =>
    this.comparison.active.filter((standing) => standing.scene === scene).flatMap(({ key }) => [...(this.rows.of(key)?.values() ?? [])])[0]
      ?.link

  /** The rows that still apply stay; while it runs, what is missing is run next. */
  private changed(): void {
    this.cursor = 0
    this.since = { at: performance.now(), done: this.done }
    this.left = null
    if (this.running && !this.stopping) {
      this.recall()
      this.trials.start()
    }
    void this.restore()
    void this.refresh()
  }

  // The runs

  run = (): void => {
    this.notice = ''
    this.comparison.refusals = {}
    this.running = true
    this.stopping = false
    this.cursor = 0
    this.since = { at: performance.now(), done: this.done }
    this.rows.guard(this.running)
    this.trials.start()
  }

  stop = (): void => {
    this.stopping = true
    this.trials.stop()
  }

  /** Long runs of a plan that was left would hold up those that are wanted. */
  private recall(): void {
    const { active, from, count } = this.comparison
    const keys = new Set(active.map(({ key }) => key))
    this.trials.recall(({ key, seed }) => keys.has(key) && seed >= from && seed < from + count)
  }

  private next(): Errand | null {
    const { plan, active, allowance } = this.comparison
    if (!plan) return null
    while (this.cursor < active.length * plan.count) {
      const { planner, params, chosen, key, scene, maps } = active[this.cursor % active.length] ?? {}
      const seed = plan.from + Math.floor(this.cursor / active.length)
      this.cursor += 1
      const id = `${key} ${seed}`
      if (!planner || !scene || key === undefined || this.rows.of(key)?.has(seed) || this.begun.has(id)) continue
      this.begun.add(id)
      this.names.set(key, this.nameOf(key))
      const setup = { planner: planner.name, ...codeOf(planner), scene, params: params ?? {}, seed }
      return { key, seed, setup, maps: maps ?? null, budget: allowance, most: chosen?.most ?? null }
    }
    return null
  }

  private take({ key, seed }: Errand, ending: Ending): void {
    this.begun.delete(`${key} ${seed}`)
    if (ending.is === 'over') {
      this.rows.add({ key, name: this.names.get(key) ?? key }, seed, ending.row)
      this.rows.forgetBut(this.comparison.active.map((standing) => standing.key))
      this.telling ??= setTimeout(() => this.tell(), TELLING)
    } else if (ending.is === 'refused') {
      this.comparison.refusals = { ...this.comparison.refusals, [key]: ending.refusal.message }
      this.cursor = 0
    } else if (ending.is === 'stopped') {
      // It may be wanted again by now.
      this.cursor = 0
    } else {
      this.notice = text.run.broken(ending.message)
    }
  }

  /** What the rows of a key have in common, whatever page they were computed in: the core, planner and its code, ground and parameters. */
  private nameOf(key: string): string {
    const { standings, allowance } = this.comparison
    const { planner, params, scene, maps } = standings.find((candidate) => candidate.key === key) ?? {}
    const common = [CORE_VERSION, planner?.name, maps ?? scene, params, ...(isOwn(planner) ? [planner.code] : [])]
    return JSON.stringify(allowance === null ? common : [...common, allowance])
  }

  /** Takes in what the browser keeps of this plan. */
  private async restore(): Promise<void> {
    if (await this.rows.restore(this.comparison.active.map(({ key }) => ({ key, name: this.nameOf(key) })))) this.tell()
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
    // How long some runs last is being found out: they begin then.
    if (this.comparison.waiting && !this.stopping) return
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
    const { plan, active, allowance, worker } = this.comparison
    if (!plan) return
    const groups = active
      .map(({ entrant, label, key, params }) => ({
        slot: entrant.slot,
        label,
        key,
        planner: entrant.planner,
        params,
        rows: this.seeds.flatMap((seed) => this.rows.of(key)?.get(seed) ?? []),
      }))
      .filter(({ rows }) => rows.length > 0)
      .map((group) => ({ ...group, lots: drawsLots(group.rows) }))
    if (groups.length === 0) {
      this.shown = null
      return
    }
    const relative = inGaps(plan, groups)
    const answer = await worker.summarise(groups, relative)
    this.shown = shownOf({ plan, allowance }, groups, answer, this.looks.at(plan, groups), relative)
  }
}

export const batchOf = perLab((lab: Lab) => new Batch(comparisonOf(lab)))
