import type { OwnPlanner } from '../catalogue/own'
import { isOwn } from '../catalogue/own'
import { code } from '../locales/en/code'
import { workshop as text } from '../locales/en/workshop'
import { Aborted, pool } from '../engine/pool'
import type { Answer, Line, Refusal } from '../engine/protocol'
import type { Conformance } from '../engine/trial.protocol'
import { sameScene } from '../scene/equality'
import type { Variable } from '../text/variables'
import { changes } from '../text/variables'
import { perLab } from './context.svelte'
import { forgetRun, rememberRun } from './kept-run'
import type { Lab } from './lab.svelte'
import { DRAFT, type Draft, readCode, recallDraft, rememberDraft } from './own-code'
import { unlessGone } from './questions'
import { recall, remember } from './storage'

/** Where the browser keeps what was in the editor before. */
const LAST = 'workshop.last'
/** After so many milliseconds without a key the code is run. */
const PAUSE = 700

/** So many characters that were pasted may be a planner. */
const SHORT = 80

/** What is wrong with a code, and where: lines from 1. */
export interface Problem {
  message: string
  line: number | null
  column: number | null
  /** What that usually means. */
  meaning: string
}

/** What an iteration changed. */
export interface Changed {
  iteration: number
  changed: readonly Variable[]
  /** How many numbers and texts stayed the same. */
  same: number
}

/** Where a message says in which line it is. */
const LINE = / \(line (\d+)\)/

function problemOf({ message, line, column }: Pick<Refusal, 'message' | 'line' | 'column'>): Problem {
  const said = message.replace(/^code: /, '')
  const at = line ?? (Number(LINE.exec(said)?.[1]) || null)
  // Of a run that failed it is quoted.
  const core = /“(.+)”/s.exec(said)?.[1] ?? code.starts.exec(said)?.[1] ?? said
  const meaning = text.explanations.find(([pattern]) => pattern.test(core))?.[1] ?? ''
  return { message: core, line: at, column: column ?? null, meaning }
}

/** A planner while it is written. */
export class Workshop {
  /** What is in the editor. */
  text = $state.raw('')
  /** What was in the editor before another code took its place. */
  last = $state.raw(recallDraft(LAST))
  /** The name of the template that it was made of. */
  template = $state('')
  /** Somebody else wrote it, or what it was made of. */
  foreign = $state(false)
  auto = $state(recall('workshop.auto') !== 'no')
  /** What is wrong with the code that was read last. */
  private refused = $state.raw<Problem | null>(null)
  lines = $state.raw<readonly Line[]>([])
  changed = $state.raw<Changed | null>(null)
  /** What the checks of the planner found. */
  checked = $state.raw<Conformance | null>(null)
  /** They are being made. */
  checking = $state(false)
  /** The line of a part of the described planner, as the editor finds it. */
  lineOf: (field: string) => number | null = () => null
  /** The text before something was taken out last: that may be put in again. */
  private uncut = ''
  private checks: AbortController | null = null
  private timer: ReturnType<typeof setTimeout> | undefined
  private request = 0

  /** The planner that the page runs, if somebody wrote it. */
  readonly planner = $derived.by<OwnPlanner | null>(() => (isOwn(this.lab.setup.planner) ? this.lab.setup.planner : null))
  /** The page runs what is in the editor. */
  readonly current = $derived.by(() => this.planner?.code === this.text)
  /** What is wrong: with the code, or with its run. */
  readonly problem = $derived.by<Problem | null>(() => {
    if (this.refused) return this.refused
    const { outcome, refusal } = this.lab.run
    if (!this.current) return null
    if (refusal) return problemOf(refusal)
    return outcome?.status === 'failed' && !this.lab.playback.stale ? problemOf({ message: outcome.trouble ?? '' }) : null
  })

  /** The name of the scene that is shown, if it ships. */
  readonly shipped = $derived.by<string | null>(() => {
    const { present } = this.lab.scene
    const ships = present !== null && (this.lab.setup.catalogue?.scenes.some((scene) => sameScene(scene, present)) ?? false)
    return ships ? present.name : null
  })

  constructor(private readonly lab: Lab) {}

  /** What there is to edit at first: what runs, what was written here before, or this. */
  initialize(first: string): void {
    if (this.text !== '') return
    const { planner } = this
    const draft: Draft = recallDraft(DRAFT) ?? { code: first, foreign: false }
    this.text = draft.code
    this.foreign = draft.foreign
    // What was written here before is kept.
    if (planner && planner.code !== this.lab.own.resumed) this.setCode(planner.code, false, this.lab.own.foreign.has(planner.code))
  }

  /** Puts the code of before into the editor. */
  restoreLast = (): void => {
    if (this.last) this.setCode(this.last.code, true, this.last.foreign)
  }

  /** Puts a code into the editor. `run`: it runs at once. What was there is kept. */
  setCode(code: string, run: boolean, foreign = false): void {
    if (this.text !== code && this.text !== '') this.keepLast()
    this.template = ''
    this.uncut = ''
    this.foreign = foreign
    this.save(code)
    this.refused = null
    if (run) void this.apply()
  }

  /** Another code runs than before: undone, say. If the editor had what ran before, it has what runs now. */
  follow(before: string | undefined, now: string): void {
    if (before !== this.text || now === this.text) return
    this.keepLast()
    this.uncut = ''
    this.foreign = this.lab.own.foreign.has(now)
    this.refused = null
    this.save(now)
  }

  /** What is in the editor, in another language: it runs if what was there did. */
  translate(code: string): void {
    if (code === this.text) return
    const { current } = this
    this.uncut = ''
    this.refused = null
    this.save(code)
    if (current) void this.apply(true)
  }

  private keepLast(): void {
    this.last = { code: this.text, foreign: this.foreign }
    rememberDraft(LAST, this.last)
  }

  private save(code: string): void {
    clearTimeout(this.timer)
    this.stopChecks()
    this.checked = null
    this.text = code
    rememberDraft(DRAFT, { code, foreign: this.foreign })
  }

  /** The code was changed. `brought`: what was pasted of that. */
  write = (code: string, brought = ''): void => {
    if (code === this.text) return
    this.checkOrigin(code, brought)
    if (code.length < this.text.length) this.uncut = this.text
    this.save(code)
    if (this.auto) this.timer = setTimeout(() => void this.apply(), PAUSE)
  }

  /** What came from elsewhere stays foreign when it is pasted; of other pasted code only the user knows who wrote it. */
  private checkOrigin(code: string, brought: string): void {
    const { own, notices } = this.lab
    const copied = brought.trim()
    if ([...own.foreign].some((one) => one.trim() === code.trim() || (copied.length > SHORT && one.includes(copied)))) {
      this.foreign = true
    } else if (own.full && !this.foreign && copied.length > SHORT && !this.text.includes(copied) && !this.uncut.includes(copied)) {
      own.disableFullSpeed()
      notices.text = text.pasted
    }
  }

  setAuto = (auto: boolean): void => {
    this.auto = auto
    remember('workshop.auto', auto ? 'yes' : 'no')
    clearTimeout(this.timer)
    if (auto && !this.current) void this.apply()
  }

  /** With or without an interpreter. */
  setFullSpeed = (full: boolean): void => {
    if (full) this.lab.own.full = true
    else this.lab.own.disableFullSpeed()
    if (this.lab.notices.text === text.pasted) this.lab.notices.text = ''
    void this.apply()
  }

  /** Runs the code, from where the run is. */
  run = async (): Promise<void> => {
    const { pending } = this.lab.own
    const brings = pending?.code === this.text && pending.link !== null
    await this.apply()
    // Pressed, it goes on, or begins again where it is over; what came with a link stands where that says.
    if (this.refused === null && !brings) this.lab.playback.play()
  }

  /** Reads the code and shows its planner: where the run is, if it is one of the same name. `reworded`: only its texts differ. */
  private async apply(reworded = false): Promise<void> {
    clearTimeout(this.timer)
    this.request += 1
    const { request, text: code } = this
    if (this.foreign) this.lab.own.foreign.add(code)
    const full = this.lab.own.full && !this.foreign
    const runs = this.current && full === this.lab.atFullSpeed
    const answer = await readCode(this.lab.own, code, full).catch(unlessGone)
    if (request !== this.request) return
    this.refused = answer && !answer.ok ? this.problemIn(code, answer.refusal) : null
    if (!answer?.ok) return
    const { pending } = this.lab.own
    this.lab.own.pending = null
    // It came with a run.
    if (pending?.link && pending.code === code) void this.lab.openLink(pending.link)
    else if (!runs) this.lab.setup.runOwn(answer.value, reworded)
  }

  /** What is wrong with a code: of what its planner says of itself only the field is known, not the place. */
  private problemIn(code: string, refusal: Refusal): Problem {
    const problem = problemOf(refusal)
    const described = refusal.field !== '' && refusal.field !== 'code' && this.text === code
    return { ...problem, line: problem.line ?? (described ? this.lineOf(refusal.field) : null) }
  }

  /** Checks whether the planner keeps to what planners must, on the scene that is shown if it ships. */
  check = async (): Promise<void> => {
    const { planner } = this
    if (!planner) return
    this.stopChecks()
    const checks = new AbortController()
    this.checks = checks
    this.checking = true
    this.checked = null
    try {
      const answer = await pool().run<Answer<Conformance>>((api) => api.conform(planner.code, this.shipped), { signal: checks.signal })
      if (this.checks !== checks) return
      if (answer.ok) this.checked = answer.value
      else this.refused = problemOf(answer.refusal)
    } catch (error) {
      if (this.checks === checks && error instanceof Error && !(error instanceof Aborted))
        this.refused = problemOf({ message: error.message })
    } finally {
      if (this.checks === checks) this.stopChecks()
    }
  }

  stopChecks = (): void => {
    const { checks } = this
    this.checks = null
    this.checking = false
    checks?.abort()
  }

  /** The browser keeps a run of the user's own planner, so that it is there again when the page is. */
  keepRun(link: string | null): void {
    const { planner } = this
    if (!planner) return
    // The planner of this name may be another one by now.
    const isOwn = planner.packed !== null && link?.includes(planner.packed) && !this.lab.own.foreign.has(planner.code)
    if (isOwn && link !== null) rememberRun(link)
    else if (link !== null || planner.packed === null) forgetRun()
  }

  /** Asks what the planner has printed. */
  async loadConsole(): Promise<void> {
    const lines = this.planner ? await this.lab.api.lines().catch(unlessGone) : []
    if (lines) this.lines = lines
  }

  /** Asks what the last iteration changed. What is known stays until a run answers: one that begins has no state yet. */
  async loadVariables(): Promise<void> {
    if (!this.planner) this.changed = null
    const answer = this.planner ? await this.lab.api.states().catch(unlessGone) : null
    if (!answer?.ok || !answer.value) return
    const { iteration, before, now } = answer.value
    this.changed = { iteration, ...changes(before, now) }
  }
}

export const workshopOf = perLab((lab) => new Workshop(lab))
