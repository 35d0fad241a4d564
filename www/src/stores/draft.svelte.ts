import type { Item } from 'forage-lab'
import { type Draft, draftOf, type DraftStep, emptyDraft, lessonOfDraft, nameFor } from '../lessons/draft'
import type { Lesson } from '../lessons/format'
import { sameScene } from '../scene/equality'
import type { Lab } from './lab.svelte'
import { forget, recall, remember } from './storage'

const KEY = 'draft'
/** The browser is written to this often, in milliseconds. */
const INTERVAL = 400

function kept(): Draft {
  try {
    const draft: unknown = JSON.parse(recall(KEY) ?? 'null')
    return typeof draft === 'object' && draft !== null ? { ...emptyDraft(), ...draft } : emptyDraft()
  } catch {
    return emptyDraft()
  }
}

/** The lesson that is written in this browser. It is kept there until it is deleted. */
class DraftStore {
  present = $state.raw<Draft>(kept())
  private timer: ReturnType<typeof setTimeout> | undefined

  readonly isEmpty = $derived(this.present.steps.length === 0 && this.present.title === '')

  change = (change: Partial<Draft>): void => {
    this.present = { ...this.present, ...change }
    clearTimeout(this.timer)
    this.timer = setTimeout(() => remember(KEY, JSON.stringify(this.present)), INTERVAL)
  }

  changeStep(at: number, change: Partial<DraftStep>): void {
    this.change({ steps: this.present.steps.map((step, own) => (own === at ? { ...step, ...change } : step)) })
  }

  /** A step to another place. */
  move(from: number, to: number): void {
    const steps = [...this.present.steps]
    const [step] = steps.splice(from, 1)
    if (!step || to < 0 || to > steps.length) return
    steps.splice(to, 0, step)
    this.change({ steps })
  }

  remove(at: number): void {
    this.change({ steps: this.present.steps.filter((_, own) => own !== at) })
  }

  /** The run as it is shown, as another step; returns how many there are then. Nothing while there is no run. */
  capture(lab: Lab): number | null {
    const { scene, setup, playback, selection, layers, picture } = lab
    if (!scene.present || lab.run.failed) return null
    const { planner, params = {}, seed = 0 } = setup.wanted(scene.present)
    const { present } = scene
    const shipped = setup.catalogue?.scenes.some((known) => sameScene(known, present))
    const { camera } = picture
    const step: DraftStep = {
      name: nameFor(
        `step ${this.present.steps.length + 1}`,
        this.present.steps.map(({ name }) => name),
      ),
      title: '',
      text: '',
      run: { planner, scene: (shipped ? present.name : present) as DraftStep['run']['scene'], params, seed },
      at: playback.target ?? playback.iteration,
      ...(selection.inspection && { item: itemOf(selection.inspection.item) }),
      ...(Object.keys(layers.chosen).length > 0 && { layers: { ...layers.chosen } }),
      ...(camera && 'zoom' in camera && { camera: { center: [camera.center[0], camera.center[1]], zoom: camera.zoom } }),
    }
    this.change({ steps: [...this.present.steps, step] })
    return this.present.steps.length
  }

  open(lesson: Lesson): void {
    this.change(draftOf(lesson))
  }

  clear(): void {
    clearTimeout(this.timer)
    this.present = emptyDraft()
    forget(KEY)
  }

  /** The file as it stands; the reader says what is wrong with it. */
  get lesson(): Lesson {
    return lessonOfDraft(this.present)
  }
}

const itemOf = ({ role, index }: Item): { role: string; index: number } => ({ role, index })

export const draft = new DraftStore()
