import type { ArmScene, DiscsScene, GridScene, NamedFile, Point, Problem, Scene } from 'forage-lab'
import { add, edited, move, place, type Plane, remove, rounded, type Selection } from '../scene/edits'
import type { Requests } from '../engine/requests'
import { movingOf } from '../scene/moving'
import { stopsOf, withStops } from '../scene/stops'
import { unlessGone } from './questions'
import type { SelectionStore } from './selection.svelte'
import type { Subject } from './subjects'

/** Key presses that follow each other within this many milliseconds are one edit. */
const NUDGING = 800

/** Files that a scene was read from, and what there is to say about it. */
export interface ImportedFiles {
  files: NamedFile[]
  notes: string[]
  problems: Problem[]
  /** Which of the problems the scene has the ends of. */
  problem: number
}

/** The scene and its edits. */
export class SceneStore {
  private scene = $state.raw<Scene | null>(null)
  /** A scene while it is being dragged. */
  private draft = $state.raw<Scene | null>(null)
  /** What was told of the files that the scene was read from. */
  imported = $state.raw<ImportedFiles | null>(null)
  private nudged: { selection: Selection; at: number } | null = null

  readonly present = $derived(this.draft ?? this.scene)
  readonly discs = $derived<DiscsScene | null>(this.present?.kind === 'discs' ? this.present : null)
  readonly grid = $derived<GridScene | null>(this.present?.kind === 'grid' ? this.present : null)
  /** A scene in space. */
  readonly arm = $derived<ArmScene | null>(this.present?.kind === 'arm' ? this.present : null)
  readonly plane = $derived<Plane | null>(
    this.present && this.present.kind !== 'function' && this.present.kind !== 'arm' ? this.present : null,
  )
  /** Where there is something to call at, in the scene's order. */
  readonly stops = $derived(this.present ? stopsOf(this.present) : [])
  /** What moves in it, in its order. */
  readonly moving = $derived(this.present ? movingOf(this.present) : [])
  /** The scene has a robot with an outline. */
  readonly hasRobot = $derived(this.grid?.robot?.length !== undefined && this.grid.robot.width !== undefined)

  /** `again`: the run begins again for an edit; `continued`: it goes on with the one before. */
  constructor(
    private readonly selected: SelectionStore,
    private readonly requests: Requests<Subject>,
    private readonly again: (continued: boolean) => unknown,
  ) {}

  /** Another scene takes the place. */
  put(scene: Scene): void {
    this.requests.note('scene')
    this.scene = scene
    this.draft = null
    this.selected.object = null
    this.imported = null
  }

  /** The answer to a request for a scene, or what is needed for one; null if there is another one meanwhile: the last request counts. */
  ask = async <T>(ask: () => Promise<T>): Promise<T | null> => {
    const request = this.requests.note('scene')
    const answer = await ask().catch(unlessGone)
    return this.requests.replaced(request, 'scene') ? null : answer
  }

  /** An edit on its way, shown and run at once; `edit` with the last of them ends it. */
  drag = (scene: Scene): void => {
    const continued = this.draft !== null
    this.draft = edited(scene)
    this.again(continued)
  }

  /** Lets go of an edit that wasn't meant. */
  abandon = (): void => {
    if (!this.draft) return
    this.draft = null
    this.again(true)
  }

  /** What was being dragged stays as it is now. */
  settle = (): void => {
    if (this.draft) this.edit(this.draft)
  }

  edit = (scene: Scene): void => {
    if (!this.scene) return
    const continued = this.draft !== null
    this.draft = null
    this.scene = edited(scene)
    this.again(continued)
  }

  addDisc = (x: number, y: number, radius: number): void => {
    const { discs } = this
    if (!discs) return
    this.edit(add(discs, { center: [x, y], radius }))
    this.selected.object = { kind: 'disc', index: discs.discs.length }
  }

  addStop = (at: Point): void => {
    const { plane, stops } = this
    const added = plane && withStops(plane, (before) => [...before, [rounded(at[0]), rounded(at[1])]])
    if (!added || added === plane) return
    this.edit(added)
    this.selected.object = { kind: 'stop', index: stops.length }
  }

  removeSelected = (): void => {
    const {
      plane,
      selected: { object: selection },
    } = this
    const without = plane && remove(plane, selection)
    if (!without || without === plane) return
    this.selected.object = null
    this.edit(without)
  }

  nudge = (dx: number, dy: number): void => {
    const {
      plane,
      selected: { object: selection },
    } = this
    if (!plane || !selection) return
    const [x, y] = place(plane, selection)
    this.press(move(plane, selection, [x + dx, y + dy]))
  }

  /** A change of what is selected by a key. A row of key presses is one edit. */
  press = (scene: Scene): void => {
    const selection = this.selected.object
    const before = this.present
    if (!selection || scene === before) return
    const goesOn = this.nudged?.selection === selection && performance.now() - this.nudged.at < NUDGING
    if (goesOn) {
      this.scene = edited(scene)
      this.again(true)
    } else {
      this.edit(scene)
    }
    this.nudged = { selection, at: performance.now() }
  }
}
