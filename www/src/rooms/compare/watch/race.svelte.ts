import type { Scene } from 'forage-lab'
import { perLab } from '../../../stores/context.svelte'
import type { Lab } from '../../../stores/lab.svelte'
import { sameScene } from '../../../scene/equality'
import { route } from '../../../stores/route.svelte'
import type { Size, View } from '../../../render/view'
import { type Comparison, comparisonOf } from '../plan/comparison.svelte'
import { Lane } from './lane.svelte'
import { Times } from './times.svelte'
import type { Side } from '../../../render/space/orbit'
import { ranks } from './standings'

/** What is compared, side by side, all with the first seed. There is one clock, in evaluations. */
export class Race extends Times {
  /** All lanes are seen alike. */
  view = $state.raw<View | null>(null)
  size = $state.raw<Size>({ width: 1, height: 1 })
  side = $state<Side>('corner')

  readonly ranks = $derived(ranks(this.lanes.map(({ racing, mark }) => (racing ? mark : null))))
  /** Of the runs that are here: what is compared may be another one already. */
  scene = $state.raw<Scene | null>(null)
  seed = -1
  /** What is to be done once all have begun. */
  private wanted: { play?: boolean; at?: number } = {}

  constructor(
    private readonly lab: Lab,
    readonly comparison: Comparison,
  ) {
    super()
  }

  protected override get most(): number | null {
    return this.comparison.allowance
  }

  /** Goes over to what is compared now: on another scene or seed all begin again, else those that run otherwise. */
  follow = async (): Promise<void> => {
    const { scene, from, active, waiting, allowance } = this.comparison
    if (!scene || waiting) return
    const again = from !== this.seed || !this.scene || !sameScene(scene, this.scene)
    if (!this.scene || !sameScene(scene, this.scene)) this.view = null
    this.scene = scene
    this.seed = from
    const kept = new Map(this.lanes.map((lane) => [lane.slot, lane]))
    const fresh: Lane[] = []
    this.lanes = active.map(({ entrant, params, chosen, label, scene: own }) => {
      const lane = kept.get(entrant.slot) ?? new Lane(this.lab.setup, entrant.slot)
      kept.delete(entrant.slot)
      lane.label = label
      const spends = allowance && chosen ? { budget: allowance, ...chosen } : null
      if (lane.asks({ planner: entrant.planner, params, scene: own, spends })) fresh.push(lane)
      return lane
    })
    for (const lane of kept.values()) lane.dismiss()
    if (again || fresh.length === this.lanes.length) await this.startAll()
    else await Promise.all(fresh.map((lane) => this.enter(lane)))
  }

  /** All begin again with what is compared, and then play, or go to a time. */
  restart(wanted: { play?: boolean; at?: number }): void {
    this.wanted = wanted
    this.seed = -1
    void this.follow()
  }

  /** One begins again and goes where the others are. */
  enter = async (lane: Lane): Promise<void> => {
    const { seed, turns } = this
    const begun = await lane.start(seed)
    if (begun && turns === this.turns) this.gather()
  }

  /** All begin again. */
  private async startAll(): Promise<void> {
    const { scene, seed } = this
    this.turns += 1
    const turn = this.turns
    this.stop()
    if (!scene) return
    this.starting = true
    await Promise.all(this.lanes.map((lane) => lane.start(seed)))
    if (turn !== this.turns) return
    this.starting = false
    this.started += 1
    const { at, play = false } = this.wanted
    this.wanted = {}
    if (at !== undefined) this.goal = at
    this.rewind()
    if (play) this.play()
  }

  /** The link of a run on this scene. */
  link = async (scene: Scene): Promise<string | undefined> => {
    const found = await this.racing.find((lane) => lane.scene === scene)?.link()
    return found?.ok ? found.value : undefined
  }

  /** Exactly this run, where it stands. */
  openInLab = async (lane: Lane): Promise<void> => {
    this.pause()
    const link = await lane.link()
    if (!link.ok) return
    route.go('lab')
    await this.lab.openLink(link.value)
  }
}

export const raceOf = perLab((lab) => new Race(lab, comparisonOf(lab)))
