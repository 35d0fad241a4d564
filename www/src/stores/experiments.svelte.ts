import type { RunSetup } from '../catalogue/own'
import type { Scene } from 'forage-lab'
import { extent, type Flat } from '../render/view'
import { sameScene } from '../scene/equality'
import { type History, historyOf } from './curve'
import type { PlaybackStore } from './playback.svelte'
import type { RunStore } from './run.svelte'

/** What a run had shown when it was left. */
export interface Ghost {
  curve: History
  /** In space, the tip's; of a function, a mark around the best position. */
  path: readonly Flat[] | null
  /** The length of the result, or what it cost. */
  value: number | null
}

/** A run that was looked at, and where it stood. */
export interface Experiment {
  setup: RunSetup
  iteration: number
  ghost: Ghost | null
}

/** As a part of the scene's side. */
const MARK = 0.02

/** A diamond around a position. */
function markAt(position: readonly number[] | undefined, scene: Scene): Flat[] | null {
  if (!position) return null
  const [x = 0, y = 0] = position
  const { min, max } = extent(scene)
  const [a, b] = [MARK * (max[0] - min[0]), MARK * (max[1] - min[1])]
  return [
    [x, y - b],
    [x + a, y],
    [x, y + b],
    [x - a, y],
    [x, y - b],
  ]
}

/** More of them nobody goes back. */
const DEPTH = 50

const same = (a: RunSetup, b: RunSetup): boolean =>
  a.planner === b.planner &&
  a.code === b.code &&
  a.seed === b.seed &&
  JSON.stringify(a.params) === JSON.stringify(b.params) &&
  typeof a.scene === 'object' &&
  typeof b.scene === 'object' &&
  sameScene(a.scene, b.scene)

/** What was looked at before, and where each change led away from it: a change loses nothing. */
export class ExperimentsStore {
  private past = $state.raw<readonly Experiment[]>([])
  private future = $state.raw<readonly Experiment[]>([])
  /** What the present run is compared with: it was left for this one. */
  shown = $state.raw<Experiment | null>(null)
  /** What is wanted now. */
  private current: RunSetup | null = null
  /** How it was before the newest change. */
  private before: { setup: RunSetup; past: readonly Experiment[]; future: readonly Experiment[]; shown: Experiment | null } | null = null

  readonly canUndo = $derived(this.past.length > 0)
  readonly canRedo = $derived(this.future.length > 0)

  constructor(
    private readonly run: () => RunStore,
    private readonly playback: () => PlaybackStore,
  ) {}

  /** A run is wanted. */
  want(setup: RunSetup): void {
    this.current = setup
    if (!this.before || !same(setup, this.before.setup)) return
    // What was refused, or let go of, led nowhere.
    const { past, future, shown } = this.before
    Object.assign(this, { past, future, shown, before: null })
  }

  /**
   * The present run is left for another. `compares`: that one is to be compared with it. `mends`: this one failed, or was never seen,
   * and the other takes its place.
   */
  leave({ compares, mends = false }: { compares: boolean; mends?: boolean }): void {
    const left = this.snapshot()
    if (!left) return
    this.before = { setup: left.setup, past: this.past, future: this.future, shown: this.shown }
    if (mends) return
    this.past = [...this.past, left].slice(-DEPTH)
    this.future = []
    this.shown = compares && left.ghost ? left : null
  }

  /** The result of the run that the present one is compared with, where it is of the same place. */
  ghostOn(scene: Scene | null): readonly Flat[] | null {
    const before = this.shown?.setup.scene
    const same = typeof before === 'object' && before.kind === scene?.kind && before.name === scene.name
    return same ? (this.shown?.ghost?.path ?? null) : null
  }

  dismiss = (): void => {
    this.shown = null
  }

  /** The experiment before the present one, or the one that was undone last; null if there is none. */
  travel(by: 'undo' | 'redo'): Experiment | null {
    this.before = null
    const [from, to] = by === 'undo' ? [this.past, this.future] : [this.future, this.past]
    const rest = [...from]
    const found = rest.pop()
    const left = this.snapshot()
    const grown = found && left ? [...to, left] : to
    if (by === 'undo') [this.past, this.future] = [rest, grown]
    else [this.future, this.past] = [rest, grown]
    if (found) this.shown = left?.ghost ? left : null
    return found ?? null
  }

  private snapshot(): Experiment | null {
    const { current } = this
    const [run, playback] = [this.run(), this.playback()]
    if (!current || !run.present) return null
    const { iteration, stale } = playback
    const { outcome } = run
    const ghost = !stale &&
      iteration > 0 && {
        curve: historyOf(run.course.curve),
        path: outcome?.tip_path ?? outcome?.path ?? markAt(outcome?.position, run.present.scene),
        value: outcome?.length ?? outcome?.cost ?? null,
      }
    return { setup: current, iteration: playback.restarting ? playback.requested.at : iteration, ghost: ghost || null }
  }
}
