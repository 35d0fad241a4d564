import type { UncheckedSetup } from 'forage-lab'
import { en } from '../locales/en/page'
import type { Questions } from '../engine/host/questions'
import type { Answer, Progress, Refusal, Report, Start, Target } from '../engine/protocol'
import { Requests } from '../engine/requests'
import { Gone, type RunClient } from '../engine/run-client'
import type { Followers } from './followers.svelte'
import { Scenes } from './scenes.svelte'

const unlessGone = (error: unknown): null => {
  if (!(error instanceof Gone)) throw error
  return null
}

const isUnloaded = (answer: unknown): answer is { ok: false; refusal: Refusal } =>
  typeof answer === 'object' && answer !== null && (answer as Partial<Extract<Answer<unknown>, { ok: false }>>).refusal?.unloaded === true

/** A refusal as it is shown: where a part could not be loaded, the reason is the browser's. */
export const worded = (refusal: Refusal): Refusal =>
  refusal.unloaded ? { ...refusal, message: en.notices.unloaded(refusal.message) } : refusal

/** Where a run begins. */
export type Opening = Omit<Start, 'setup'>

/** What requests are about. */
type Subject = 'iteration' | 'playing' | 'scene' | 'setup' | 'seed' | 'inspection' | 'run'

/** Where the run is and where the user wants it. The engine converges to the newest. */
export abstract class Transport extends Scenes {
  iteration = $state(0)
  playing = $state(false)
  /** Where a seek, or a new run, is on its way to. */
  target = $state<number | null>(null)
  speed = $state(30)
  /** How far a step is that takes its time. */
  underway = $state.raw<Progress | null>(null)
  /** Of the run, where it was wanted: empty before it is there. */
  hash = $state('')

  protected readonly requests = new Requests<Subject>()
  /** A new run is on its way. */
  protected restarting = $state(false)
  /** Steps that are taken once the changes before them are known, and the number of the newest request for one. */
  private steps: { n: number; since: number } | null = null
  /** Answers that changes wait for. Each is listed until it was acted on. */
  protected awaited = $state.raw<readonly Promise<void>[]>([])

  abstract readonly limit: number
  /** True from a change until its first picture: the old one must not pass for the new. */
  abstract readonly stale: boolean
  abstract readonly followers: Followers
  protected abstract readonly client: RunClient
  /** Nothing but the run itself is shown. */
  protected abstract stopPlayback(): void

  /** For questions to the run. A refusal says in the page's words that a part could not be loaded. */
  readonly api = new Proxy({} as Questions, {
    get:
      (_, name: string) =>
      async (...given: unknown[]) => {
        const questions = this.client.api as unknown as Record<string, (...given: unknown[]) => Promise<unknown>>
        const answer = await questions[name]?.(...given)
        return isUnloaded(answer) ? { ...answer, refusal: worded(answer.refusal) } : answer
      },
  })

  /** The answer to a request for a scene; null if there is another one meanwhile. */
  askForScene = async <T>(ask: () => Promise<T>): Promise<T | null> => {
    const request = this.requests.note('scene')
    const answer = await ask().catch(unlessGone)
    return this.requests.replaced(request, 'scene') ? null : answer
  }

  /** Asks something that a change depends on, and makes the change. */
  protected await<T>(ask: () => Promise<T>, change: (answer: T) => void): Promise<void> {
    const changed = ask()
      .then(change)
      .catch((error: unknown) => void unlessGone(error))
    this.awaited = [...this.awaited, changed]
    return changed.finally(() => (this.awaited = this.awaited.filter((other) => other !== changed)))
  }

  /** Starts a run; returns the number of this change. A seek, play or pause that was requested after request number `since` holds for it. */
  protected start(setup: UncheckedSetup, { at, play }: Opening, since = this.requests.note('setup')): number {
    this.requested = {
      at: this.requests.replaced(since, 'iteration') ? this.requested.at : at,
      play: this.requests.replaced(since, 'playing') ? this.requested.play : play,
    }
    this.requests.note('run')
    const version = this.client.want({ start: { setup, ...this.requested, check: this.checks } })
    this.showHeading()
    return version
  }

  /** Something of the setup waits for being accepted. */
  protected abstract readonly checks: boolean

  /** Where the newest request wants the run, or its successor. */
  protected requested: Opening = { at: 0, play: false }

  private head(target: Target): void {
    this.requested = { at: target.at ?? this.requested.at, play: target.play }
    this.requests.note('playing', ...(target.at === undefined ? [] : (['iteration'] as const)))
    this.client.want({ target })
    this.showHeading()
  }

  /** Shows what is wanted before there is a picture of it. */
  protected showHeading(): void {
    const { at = null, play } = this.client.heading
    this.playing = play
    this.target = at
    this.restarting = this.client.starting
    this.hash = ''
  }

  /** The run has come farther. */
  protected showReport(report: Report): void {
    this.iteration = report.iteration
    this.showHeading()
    this.hash = (!this.restarting && this.client.follows(report) ? report.hash : null) ?? ''
  }

  toggle = (): void => (this.playing ? this.pause() : this.play())

  play = (): void => {
    this.stopPlayback()
    this.setPlaying(true)
  }

  pause = (): void => {
    this.underway = null
    this.setPlaying(false)
  }

  /** Stops during a step that takes long; one that has begun is given up, what other planners found for it is kept. */
  stopStep = (): void => {
    const begun = this.underway?.done === null
    this.pause()
    if (begun) this.seek(this.iteration)
  }

  private setPlaying(play: boolean): void {
    // A new run goes where it begins all the same.
    const { at } = this.client.starting ? this.client.heading : {}
    this.head(at === undefined ? { play } : { at, play })
  }

  /** Goes to an iteration; Infinity: to the end. */
  seek = (to: number): void => {
    const iteration = Math.max(Math.round(to), 0)
    this.followers.leave()
    // How long the next run is, is not known before it has started.
    this.head({ at: this.stale ? iteration : Math.min(iteration, this.limit), play: false })
  }

  stepBy = (n: number): void => {
    const { steps } = this
    if (!steps && this.awaited.length === 0) {
      this.seek(this.place + n)
      return
    }
    this.steps = { n: n + (steps && !this.overruled(steps.since) ? steps.n : 0), since: this.requests.note() }
    if (!steps) void this.takeSteps()
  }

  /** Where a change puts the run must be known before steps can be counted from there. */
  private async takeSteps(): Promise<void> {
    while (this.awaited.length > 0) await Promise.allSettled(this.awaited)
    const { steps } = this
    this.steps = null
    if (steps && !this.overruled(steps.since)) this.seek(this.place + steps.n)
  }

  /** Nothing waits for an answer any more: the thread broke down. */
  protected forget(): void {
    this.awaited = []
    this.steps = null
    this.underway = null
    this.showHeading()
  }

  /** Whether there was a seek, play or pause after request number `since`. */
  private overruled(since: number): boolean {
    return this.requests.replaced(since, 'iteration', 'playing')
  }

  /** Where the run is, or is on its way to. */
  private get place(): number {
    const at = this.target ?? this.iteration
    return this.restarting ? at : Math.min(at, this.limit)
  }

  setSpeed = (speed: number): void => {
    this.speed = speed
    this.client.want({ speed })
  }
}
