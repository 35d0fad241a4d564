import type { Layer, Look } from 'forage-lab'
import { layersOf } from '../catalogue/parameters'
import { layerOf, type Names, namesOf, PLAIN } from '../render/looks'
import type { ParametersStore } from './parameters.svelte'
import type { RunStore } from './run.svelte'
import type { SceneStore } from './scene.svelte'
import type { SetupStore } from './setup.svelte'

/** The layers of the picture: which there are, how they look, and which are drawn. */
export class LayersStore {
  /** What somebody has chosen; else a layer is drawn as the planner's entry has it. */
  chosen = $state.raw<Readonly<Record<string, boolean>>>({})
  /** Those that there can be with these parameters. */
  readonly list = $derived.by<Layer[]>(() => {
    const { planner } = this.setup
    const scene = this.scene.present
    return planner && scene ? layersOf(planner, scene.kind, this.parameters.values) : []
  })
  readonly names = $derived.by<Names | null>(() => this.setup.catalogue && namesOf(this.setup.catalogue, this.run.drawer))

  constructor(
    private readonly scene: SceneStore,
    private readonly setup: SetupStore,
    private readonly parameters: ParametersStore,
    private readonly run: RunStore,
  ) {}

  /** The layers that are left while there may be few only. */
  only = $state.raw<ReadonlySet<string> | null>(null)

  /** The layers that stand out: all others are faint. */
  highlighted = $state.raw<readonly string[] | null>(null)

  shows = (role: string, standard: boolean): boolean => (this.only?.has(role) ?? true) && (this.chosen[role] ?? standard)

  show = (role: string, on: boolean): void => {
    this.chosen = { ...this.chosen, [role]: on }
  }

  /** How a layer of the frame, of an explanation or of the scene looks. */
  lookOf = (key: string): Look => layerOf(this.setup.catalogue, this.run.drawer, key)?.look ?? PLAIN
}
