import type { RunSetup } from '../catalogue/own'
import { untrack } from 'svelte'
import type { Item, LinkSetup, Point } from 'forage-lab'
import { SideRun } from '../engine/side-run'
import type { Lesson, Question, Step } from '../lessons/format'
import { checkNames } from '../lessons/names'
import { language } from '../locales/language.svelte'
import {
  type ArrowScore,
  type CellScore,
  type MemberScore,
  nearestTo,
  type NodeScore,
  scoreArrow,
  scoreCell,
  scoreMember,
  scoreNode,
} from '../lessons/score'
import { perLab } from './context.svelte'
import type { Lab } from './lab.svelte'
import { type Guess, progress } from './lesson-progress.svelte'
import { setupsOf } from './lesson-figures'
import { setupWith, type Truth, truthOf } from './lesson-truth'
import { stillness } from './theme.svelte'

/** A run moves to its place in so many milliseconds: at least, for each iteration, and at most. */
const [SHORT, EACH, LONG] = [400, 12, 2500]

/** A place in a run. */
interface Moment {
  at: number
  item: Item | null
}

/** How an answer compares with what came out. */
export type Score = ArrowScore | CellScore | NodeScore | MemberScore | { grade: 'right' | 'off' }

/** An eighth of a turn, counterclockwise from the right: the order of an explanation's directions. */
export const directionOf = ([x, y]: Point, [cx, cy]: Point): number => (Math.round((Math.atan2(y - cy, x - cx) * 4) / Math.PI) + 8) % 8

function scoreOf(truth: Truth, guess: Guess): Score | null {
  if ('option' in guess) return 'option' in truth ? { grade: guess.option === truth.option ? 'right' : 'off' } : null
  const { point } = guess
  switch (truth.kind) {
    case 'arrow':
      return scoreArrow(truth.from, point, truth.to)
    case 'cell':
      return scoreCell(truth.probabilities, directionOf(point, truth.centre))
    case 'node':
      return scoreNode(truth.sample, point, truth.at, Math.hypot(point[0] - truth.at[0], point[1] - truth.at[1]) < 1e-6)
    case 'member':
      return scoreMember(truth.values, nearestTo(truth.places, point))
    default:
      return null
  }
}

/** Whether an answer is one to this question. */
function answers(question: Question | undefined, guess: Guess): boolean {
  if (!question) return false
  return 'options' in question ? 'option' in guess && guess.option < question.options.length : 'point' in guess
}

/** A lesson that is read beside a run: its steps put the run where they want it, and the reader may go elsewhere at any time. */
export class LessonStore {
  lesson = $state.raw<Lesson | null>(null)
  /** The name that its address has. */
  source = $state('')
  index = $state(0)
  /** The answer that is being given. */
  guess = $state.raw<Guess | null>(null)
  /** What came out, by the names of steps, and why there is none. */
  private truths = $state.raw<Readonly<Record<string, Truth>>>({})
  private failures = $state.raw<Readonly<Record<string, string>>>({})
  private answers = $state.raw<Readonly<Record<string, Guess>>>({})
  /** What runs at each step. */
  private setups: RunSetup[] = []
  private side: SideRun | null = null
  /** What the newest step wants of the run. */
  private own = $state.raw<RunSetup | null>(null)
  private wanted = $state(0)
  /** The run is on its way to where the step wants it. */
  private travelling = $state(false)
  private request = 0
  private shown: RunSetup | null = null

  readonly step = $derived.by<Step | null>(() => this.lesson?.steps[this.index] ?? null)
  readonly steps = $derived(this.lesson?.steps ?? [])
  /** Something of the run is the reader's own. */
  readonly forked = $derived.by(() => this.own !== null && this.lab.setup.differsFrom(this.own))
  /** The run is elsewhere than the step wants it. */
  readonly away = $derived.by(
    () => this.forked || (this.own !== null && !this.travelling && (this.lab.playback.playing || this.place !== this.wanted)),
  )
  /** The step's prediction, while it waits for an answer. */
  readonly asked = $derived.by<{ question: Question; truth: Truth } | null>(() => {
    const { step } = this
    const truth = step && this.truths[step.name]
    return step?.question && truth && !this.answers[step.name] ? { question: step.question, truth } : null
  })

  constructor(private readonly lab: Lab) {}

  private get place(): number {
    return this.lab.playback.target ?? this.lab.playback.iteration
  }

  /** Begins a lesson at a step, or where it was left. Throws `LessonError` for names that there are not. */
  open(lesson: Lesson, source: string, step?: string): void {
    const { catalogue } = this.lab.setup
    if (!catalogue) return
    checkNames(lesson, catalogue)
    this.close()
    language.listeners.add(this.translate)
    this.lesson = lesson
    this.source = source
    // What runs at several steps is one run.
    const known = new Map<string, RunSetup>()
    this.setups = [...setupsOf(lesson).values()].map((setup) => {
      const text = JSON.stringify(setup)
      if (!known.has(text)) known.set(text, setup)
      return known.get(text) ?? setup
    })
    const standing = progress.of(lesson.name)
    // Those of another version of the lesson may be answers to nothing.
    this.answers = Object.fromEntries(
      Object.entries(standing.answers).filter(([name, guess]) => answers(lesson.steps.find((one) => one.name === name)?.question, guess)),
    )
    const named = step === undefined ? standing.step : lesson.steps.findIndex(({ name }) => name === step)
    this.go(Math.min(Math.max(named, 0), lesson.steps.length - 1))
  }

  /** Nobody sees it: nothing is computed until it goes on. */
  rest(): void {
    cancelAnimationFrame(this.request)
    this.travelling = false
    this.side?.close()
    this.side = null
    this.lab.layers.highlighted = null
  }

  /** It is seen again. */
  resume(): void {
    this.lab.layers.highlighted = this.step?.highlight ?? null
    void this.find(this.index)
  }

  close(): void {
    this.rest()
    language.listeners.delete(this.translate)
    this.source = ''
    this.lesson = this.own = this.shown = this.guess = null
    this.truths = {}
    this.failures = {}
    this.lab.layers.chosen = {}
  }

  /** To a step; what the reader has made of the run is left, and can be come back to by undoing. */
  go = (index: number): void => {
    const { lesson } = this
    if (!lesson?.steps[index]) return
    this.guess = null
    this.index = index
    progress.note(lesson.name, { step: index, farthest: Math.max(index, progress.of(lesson.name).farthest) })
    this.show()
    void this.find(index)
  }

  /** The step that is read; its run is only shown where the reader has not made another one. */
  read = (index: number): void => {
    if (index === this.index || !this.lesson) return
    if (!untrack(() => this.forked)) {
      this.go(index)
      return
    }
    this.guess = null
    this.index = index
    void this.find(index)
  }

  /** The run as the step wants it. */
  show = (): void => {
    const { step, lab } = this
    const setup = this.setups[this.index]
    if (!step || !setup) return
    const { at, item } = this.momentOf(step)
    const same = this.shown === setup && !this.forked
    const begins = step.from ?? step.at
    if (!same) {
      lab.openMoment({ ...setup, scene: this.sceneOf(setup.scene), iteration: begins } as LinkSetup)
    }
    this.shown = setup
    this.own = lab.scene.present && lab.setup.wanted(lab.scene.present)
    this.look(step)
    lab.layers.chosen = step.layers ?? {}
    lab.layers.highlighted = step.highlight ?? null
    lab.selection.inspect(null)
    const from = same ? (step.from !== undefined && this.place < step.from ? step.from : this.place) : begins
    this.travel(from, at, () => lab.selection.inspect(item))
  }

  /** The run where a number of the text comes from. */
  visit = (step: string, at: number | undefined, item: { role: string; index: number } | null): void => {
    const index = this.steps.findIndex(({ name }) => name === step)
    const found = this.steps[index]
    if (!found) return
    if (index !== this.index || this.forked) this.go(index)
    this.lab.playback.seek(at ?? found.at)
    this.lab.selection.inspect((item ?? found.item ?? null) as Item | null)
  }

  /** The task's run, from its beginning; planner and scene are the last step's where the task leaves them open. */
  beginTask = (): void => {
    const { lab, lesson } = this
    const last = this.setups.at(-1)
    if (!lesson?.task || !last) return
    const { planner, scene, params } = setupWith(last, { ...lesson.task, params: lesson.task.params ?? {}, seed: 1 })
    lab.layers.highlighted = null
    lab.layers.chosen = {}
    lab.openMoment({ planner, scene: this.sceneOf(scene), params, seed: 1, iteration: 0 } as unknown as LinkSetup)
  }

  /** A scene that ships has its name. */
  private sceneOf = (scene: RunSetup['scene']): unknown =>
    typeof scene === 'string' ? this.lab.setup.catalogue?.scenes.find(({ name }) => name === scene) : scene

  /** What the stage shows of the plane: where it was looked at closer before, all of it again. */
  private look({ camera }: Step): void {
    const { picture, scene } = this.lab
    if (!scene.present || scene.present.kind === 'arm') return
    if (camera || picture.camera) picture.wantedCamera = camera ?? 'whole'
  }

  /** Where a step wants the run: once its question is answered, where the answer is seen. */
  private momentOf({ name, at, item, question }: Step): Moment {
    const own: Moment = { at, item: (item ?? null) as Item | null }
    if (!question || !this.answers[name]) return own
    switch (question.kind) {
      case 'arrow':
      case 'node':
        return { at: at + 1, item: question.item as Item }
      case 'member':
        return { at: at + 1, item: this.memberOf(name, question.role) }
      case 'cell':
        return { at, item: question.item as Item }
      case 'item':
        return { at: question.at ?? at + 1, item: question.item as Item }
      case 'run':
        return { ...own, at: question.at ?? question.shows ?? at }
      case 'compare':
        return { ...own, at: question.shows ?? at }
    }
  }

  /** The member that is the answer, once that is known. */
  private memberOf(step: string, role: string): Item | null {
    const truth = this.truths[step]
    return truth?.kind === 'member' ? ({ role, index: truth.index } as Item) : null
  }

  /** The run goes there in sight; at once where motion is unwelcome. The reader's own steps end it. */
  private travel(from: number, to: number, arrive: () => void): void {
    const { playback } = this.lab
    cancelAnimationFrame(this.request)
    this.wanted = to
    const distance = Math.abs(to - from)
    if (stillness.matches || distance <= 1) {
      this.travelling = false
      playback.seek(to)
      arrive()
      return
    }
    this.travelling = true
    const length = Math.min(SHORT + EACH * distance, LONG)
    let begun: number | null = null
    let last = from
    playback.seek(from)
    const tick = (now: number): void => {
      if (playback.requested.at !== last || playback.playing) {
        this.travelling = false
        return
      }
      // Its time begins with its picture.
      if (!playback.stale) begun ??= now
      const share = begun === null ? 0 : Math.min(1, (now - begun) / length)
      const next = Math.round(from + (to - from) * share)
      if (next !== last) playback.seek(next)
      last = playback.requested.at
      if (share < 1) {
        this.request = requestAnimationFrame(tick)
        return
      }
      this.travelling = false
      arrive()
    }
    last = playback.requested.at
    this.request = requestAnimationFrame(tick)
  }

  /** Computes what a step asks for. */
  private async find(index: number, again = false): Promise<void> {
    const { lesson } = this
    const step = lesson?.steps[index]
    const setup = this.setups[index]
    if (!step?.question || !setup || (this.truths[step.name] && !again)) return
    this.side ??= new SideRun()
    const { side } = this
    try {
      const truth = await truthOf(step.question, setup, step.at, side)
      if (side !== this.side) return
      this.truths = { ...this.truths, [step.name]: truth }
      this.failures = { ...this.failures, [step.name]: '' }
      // Which member it is that is to be explained was not known before.
      if (!again && truth.kind === 'member' && index === this.index && this.answers[step.name] && !this.forked) this.show()
    } catch (error) {
      if (side !== this.side) return
      this.failures = { ...this.failures, [step.name]: error instanceof Error ? error.message : String(error) }
    }
  }

  /** What came out is explained in the page's language. */
  private readonly translate = (): void => {
    for (const [index, { name }] of this.steps.entries()) if (this.truths[name] || this.failures[name]) void this.find(index, true)
  }

  truthOf = (step: Step): Truth | null => this.truths[step.name] ?? null

  failureOf = (step: Step): string => this.failures[step.name] ?? ''

  answerTo = (step: Step): Guess | null => this.answers[step.name] ?? null

  scoreOf(step: Step): Score | null {
    const [truth, guess] = [this.truthOf(step), this.answerTo(step)]
    return truth && guess && scoreOf(truth, guess)
  }

  /** Takes the answer that is being given, and shows what comes out. */
  answer = (): void => {
    const { guess, lesson, step } = this
    if (!guess || !lesson || !step) return
    this.answers = { ...this.answers, [step.name]: guess }
    progress.note(lesson.name, { answers: this.answers })
    this.guess = null
    this.show()
  }

  /** The question once more. */
  retry = (): void => {
    const { lesson, step } = this
    if (!lesson || !step) return
    const { [step.name]: _, ...others } = this.answers
    this.answers = others
    progress.note(lesson.name, { answers: others })
    this.show()
  }
}

/** The lesson that is read beside a lab's run. */
export const lessonOf = perLab((lab) => new LessonStore(lab))
