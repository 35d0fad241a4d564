import { sceneText } from '../text/scene-text'
import { codeOf, type OwnPlanner, type RunSetup } from '../catalogue/own'
import type { Catalogue, LinkSetup, ParameterValue, Planner, Scene, When } from 'forage-lab'
import { meaningful, met } from '../catalogue/parameters'
import { STANDARD, type Standard } from '../catalogue/standard'
import type { Questions } from '../engine/host/questions'
import type { Opening } from '../engine/protocol'
import type { Requests } from '../engine/requests'
import { common } from '../locales/en/common'
import { sameParams, sameScene } from '../scene/equality'
import { suits } from '../scene/stops'
import type { Awaited } from './awaited.svelte'
import type { NoticesStore } from './notices.svelte'
import type { ParametersStore } from './parameters.svelte'
import type { SceneStore } from './scene.svelte'
import type { Again } from './again'
import type { Subject } from './subjects'
import { stillness } from './theme.svelte'

/** What a tuning came to: a planner and its parameters. */
export interface Tuned {
  planner: string
  params: Record<string, ParameterValue>
}

/** How the run begins again, with another setup. */
export interface Begin {
  again(where?: Again, since?: number): number
  restart(opening: Opening): number
}

/** What is planned with what: planner, scene, parameters and seed. */
export class SetupStore {
  catalogue = $state.raw<Catalogue | null>(null)
  plannerName = $state('')
  seed = $state(1)
  private tuner: Tuned | null = null

  readonly planner = $derived<Planner | null>(this.catalogue?.planners.find(({ name }) => name === this.plannerName) ?? null)
  /** What is looked for is a tour through the stops: start and goal mean nothing. */
  readonly touring = $derived.by(() => this.scene.present?.kind === 'tour' || (this.scene.grid !== null && (this.planner?.stops ?? false)))
  /** It tells what happens and what it decides. */
  readonly eventful = $derived((this.planner?.events.length ?? 0) > 0)
  /** It plans in an arm's joints, and tells of each node: its costs are angles. */
  readonly inJoints = $derived(this.planner?.members.some(({ name }) => name === 'q1') ?? false)

  constructor(
    private readonly scene: SceneStore,
    private readonly parameters: ParametersStore,
    private readonly notices: NoticesStore,
    private readonly awaited: Awaited,
    private readonly requests: Requests<Subject>,
    private readonly api: Questions,
    private readonly start: Begin,
  ) {}

  private shipped(name: string): Scene {
    const scenes = this.catalogue?.scenes ?? []
    const scene = scenes.find((candidate) => candidate.name === name) ?? scenes[0]
    if (!scene) throw new Error('no scene ships')
    return scene
  }

  /** What is shown where nothing else is asked for. */
  begin({ planner, scene, seed, params }: Standard): void {
    this.plannerName = planner
    this.parameters.replace({ ...params })
    this.seed = seed
    this.scene.put(this.shipped(scene))
  }

  /** Nothing was changed since it was shown first. */
  get isStandard(): boolean {
    const { planner, scene, params } = STANDARD
    const shown = this.scene.present
    return (
      this.plannerName === planner && shown !== null && sameScene(shown, this.shipped(scene)) && sameParams(params, this.parameters.values)
    )
  }

  /** As the engine takes it, on this scene. */
  wanted(scene: Scene): RunSetup {
    const params = this.planner ? meaningful(this.planner, scene, this.parameters.wanted) : {}
    return { planner: this.plannerName, ...codeOf(this.planner), scene, params, seed: this.seed }
  }

  /** Whether what is chosen is not this. */
  differsFrom(present: RunSetup | undefined): boolean {
    const scene = this.scene.present
    if (!scene || !present) return true
    const { planner, code, seed, params } = this.wanted(scene)
    const all = [present.planner, present.code, present.seed, present.params]
    return present.scene !== scene || JSON.stringify([planner, code, seed, params]) !== JSON.stringify(all)
  }

  /** Whether a condition on the parameters is met. */
  met = (when: When | undefined): boolean => {
    const { planner } = this
    const scene = this.scene.present
    return Boolean(planner && scene && met(when, planner.parameters, scene.kind, this.parameters.values))
  }

  /** Takes all of a setup. */
  take({ planner, scene, params, seed }: Pick<LinkSetup, 'planner' | 'scene' | 'params' | 'seed'>): void {
    this.plannerName = planner
    this.scene.put(scene)
    this.parameters.replace(params)
    this.seed = seed
    this.notices.text = ''
  }

  setPlanner = (name: string): void => {
    const planner = this.catalogue?.planners.find((candidate) => candidate.name === name)
    if (!planner || name === this.plannerName) return
    this.parameters.errors = {}
    if (this.tuner?.planner === name) this.parameters.replace(this.tuner.params)
    this.tuner = null
    this.plannerName = name
    this.bringScene(planner)
    this.start.again('begin')
  }

  /** Where a planner doesn't run, it brings a scene of its own. */
  private bringScene(planner: Planner, best: (scene: Scene) => boolean = () => true): boolean {
    const { present } = this.scene
    if (!present || suits(planner, present)) return false
    const all = this.catalogue?.scenes.filter((scene) => suits(planner, scene)) ?? []
    const other = all.find(best) ?? all[0]
    if (other) this.scene.put(other)
    return other !== undefined
  }

  /** Runs a planner that somebody wrote. Another code of the same planner goes on where the run is; `reworded`: only its texts differ. */
  runOwn = (planner: OwnPlanner, reworded = false): void => {
    const same = planner.name === this.plannerName
    this.notices.text = ''
    this.parameters.errors = {}
    this.plannerName = planner.name
    // Of a function of two variables all is seen.
    const moved = this.bringScene(planner, (scene) => scene.kind !== 'function' || scene.dimension === 2)
    this.start.again(reworded ? 'words' : same && !moved ? 'code' : 'begin')
  }

  openScene = (scene: Scene): void => {
    this.notices.text = ''
    this.scene.put(scene)
    this.start.again('begin')
  }

  /** A planner, a scene, parameters and a seed at once: they show what was meant to be seen. */
  openCase = (planner: string, scene: Scene, params: Record<string, ParameterValue>, seed = 1): void => {
    this.notices.text = ''
    this.tuner = null
    this.plannerName = planner
    this.parameters.replace(params)
    this.seed = seed
    this.requests.note('seed')
    if (scene !== this.scene.present) this.scene.put(scene)
    this.start.restart({ at: 0, play: !stillness.matches })
  }

  /** Another planner takes the place of one that doesn't run on such scenes. */
  suit(scene: Scene): void {
    if (!this.planner || suits(this.planner, scene)) return
    const other = this.catalogue?.planners.find((planner) => suits(planner, scene))
    if (!other) return
    this.notices.text = common.notices.kind(this.planner.title, sceneText(scene.title), other.title)
    this.parameters.errors = {}
    this.plannerName = other.name
  }

  /** Runs the planner that was tuned, with what the tuning came to. The tuner's own parameters wait for its return. */
  useTuned = ({ planner, params }: Tuned): void => {
    this.tuner = { planner: this.plannerName, params: this.parameters.values }
    this.plannerName = planner
    this.parameters.replace(params)
    this.start.again('begin')
  }

  setSeed = (seed: number): void => {
    this.requests.note('seed')
    this.seed = seed
    this.start.again('begin')
  }

  newSeed = (): Promise<void> => {
    const request = this.requests.note('seed')
    return this.awaited.add(
      () => this.api.newSeed(),
      (seed) => {
        if (this.requests.replaced(request, 'seed')) return
        this.seed = seed
        this.start.again('begin', request)
      },
    )
  }
}
