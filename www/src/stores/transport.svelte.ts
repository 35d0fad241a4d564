import { en } from '../locales/en/page'
import type { Answer, FrameMessage, Opening, ProgressMessage, Refusal } from '../engine/protocol'
import type { Client } from '../engine/run-client'
import type { Followers } from './followers.svelte'
import { Requests } from '../engine/requests'
import { Scenes } from './scenes.svelte'

/** Of what was asked of a thread that broke down: the page says so, and offers a new thread. */
export const gone = new Error(en.crash.title)

const unlessGone = (error: unknown): null => {
  if (error !== gone) throw error
  return null
}

const isUnloaded = (answer: unknown): answer is { ok: false; refusal: Refusal } =>
  typeof answer === 'object' && answer !== null && (answer as Partial<Extract<Answer<unknown>, { ok: false }>>).refusal?.unloaded === true

/** An answer as it is shown: where a part could not be loaded, the reason is the browser's. */
export const worded = <T>(answer: T): T =>
  isUnloaded(answer) ? { ...answer, refusal: { ...answer.refusal, message: en.notices.unloaded(answer.refusal.message) } } : answer

/** What a thread has not answered is settled once it is left: asked again, or given up. */
function leaving(): { left: Promise<null>; again(): void; giveUp(): void } {
  let [again, giveUp] = [(): void => undefined, (): void => undefined]
  const left = new Promise<null>((resolve, reject) => {
    again = () => resolve(null)
    giveUp = () => reject(gone)
  })
  left.catch(() => undefined)
  return { left, again, giveUp }
}

type Api = Client['api']

/** What requests are about. */
type Subject = 'iteration' | 'playing' | 'scene' | 'setup' | 'seed' | 'parameters' | `parameter ${string}` | 'inspection' | 'run'

/**
 * Where the run is and where the user wants it. Runs are restarted and changes wait for answers while the user goes on asking:
 * the newest request holds for the run that is there in the end.
 */
export abstract class Transport extends Scenes {
  iteration = $state(0)
  playing = $state(false)
  /** Where a seek is on its way to. */
  target = $state<number | null>(null)
  speed = $state(30)
  /** Of the runs of other planners that the next step needs. */
  protected progress = $state.raw<ProgressMessage | null>(null)

  protected readonly requests = new Requests<Subject>()
  /** Where the newest request wants the run. A restart begins there. */
  protected requested: Opening = { at: 0, play: false }
  /** A restart was requested, and there is no picture of the new run yet. */
  protected outdated = $state(false)
  /** Steps that are taken once the changes before them are known, and the number of the newest request for one. */
  private steps: { n: number; since: number } | null = null
  /** Answers that changes wait for. Each is listed until it was acted on. */
  protected awaited = $state.raw<readonly Promise<void>[]>([])
  private leaving = leaving()
  /** True from a change until its first picture: the old one must not pass for the new. */
  readonly stale = $derived(this.outdated || this.awaited.length > 0)

  abstract readonly limit: number
  /** A new run is on its way; false after a start that was refused: what runs then is the run of before. */
  protected abstract readonly restarting: boolean
  abstract readonly followers: Followers
  protected abstract readonly client: Client
  /** Nothing but the run itself is shown. */
  protected abstract stopPlayback(): void

  /** What the worker answers; if another one has taken its place, what that one does. Fails with `gone` if it broke down. */
  private async answered<T>(ask: () => Promise<T>): Promise<T> {
    for (;;) {
      const answer = await Promise.race([ask().then((value) => ({ value })), this.leaving.left])
      if (answer) return worded(answer.value)
    }
  }

  /** For questions to the worker: a thread that takes its place answers what it has not. */
  readonly api = new Proxy({} as Api, {
    get:
      (_, name: string) =>
      (...given: unknown[]) =>
        this.answered(async () => (this.client.api as unknown as Record<string, (...given: unknown[]) => unknown>)[name]?.(...given)),
  })

  /** What the worker answers to a request for a scene; null if there is another one meanwhile. */
  askForScene = async <T>(ask: () => Promise<T>): Promise<T | null> => {
    const request = this.requests.note('scene')
    const answer = await ask().catch(unlessGone)
    return this.requests.replaced(request, 'scene') ? null : answer
  }

  /** A new thread is asked what the one before has not answered. */
  protected askAgain(): void {
    const { again } = this.leaving
    this.leaving = leaving()
    again()
  }

  /** Asks the worker something that a change depends on, and makes the change. */
  protected await<T>(ask: () => Promise<T>, change: (answer: T) => void): Promise<void> {
    const changed = ask()
      .then(change)
      .catch((error: unknown) => void unlessGone(error))
    this.awaited = [...this.awaited, changed]
    return changed.finally(() => (this.awaited = this.awaited.filter((other) => other !== changed)))
  }

  /** Where the next restart begins. A seek, play or pause that came after request number `since` counts more than `opening`. */
  protected putAt({ at, play }: Opening, since: number): void {
    this.requested = {
      at: this.requests.replaced(since, 'iteration') ? this.requested.at : at,
      play: this.requests.replaced(since, 'playing') ? this.requested.play : play,
    }
  }

  /** The worker had received every seek, play and pause when it sent this. */
  protected isNewest({ request }: FrameMessage): boolean {
    return !this.overruled(request)
  }

  toggle = (): void => (this.playing ? this.pause() : this.play())

  play = (): void => {
    this.stopPlayback()
    this.target = null
    this.setPlaying(true)
  }

  pause = (): void => {
    this.progress = null
    this.setPlaying(false)
  }

  /** Stops during a step that takes long; one that has begun is given up, what other planners found for it is kept. */
  stopStep = (): void => {
    const begun = this.progress?.done === null
    this.pause()
    if (begun) this.seek(this.iteration)
  }

  private setPlaying(play: boolean): void {
    this.playing = play
    this.requested = { ...this.requested, play }
    const request = this.requests.note('playing')
    const { api } = this.client
    // A run that is being restarted goes where it begins all the same.
    if (this.restarting && this.requested.at > 0) void api.seek(this.requested.at, play, request)
    else void (play ? api.play(request) : api.pause(request))
  }

  /** Goes to an iteration; Infinity: to the end. */
  seek = (to: number): void => {
    const iteration = Math.max(Math.round(to), 0)
    // How long the next run is, is not known before it has started.
    const at = this.stale ? iteration : Math.min(iteration, this.limit)
    this.followers.leave()
    this.playing = false
    this.target = at
    this.requested = { at, play: false }
    void this.client.api.seek(at, false, this.requests.note('iteration', 'playing'))
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

  /** For commands to this very worker. */
  get commands(): Api {
    return this.client.api
  }

  /** Where a new thread goes on. */
  protected get resumption(): Opening {
    return this.restarting ? this.requested : { at: this.target ?? this.iteration, play: this.playing }
  }

  /** The thread broke down: what it was asked may be why, and is not asked again. */
  protected forget(): void {
    this.playing = false
    this.target = null
    this.awaited = []
    this.steps = null
    const { giveUp } = this.leaving
    this.leaving = leaving()
    giveUp()
  }

  /** Whether there was a seek, play or pause after request number `since`. */
  private overruled(since: number): boolean {
    return this.requests.replaced(since, 'iteration', 'playing')
  }

  /** Where the run is, or is on its way to. */
  private get place(): number {
    return this.restarting ? this.requested.at : Math.min(this.target ?? this.iteration, this.limit)
  }

  setSpeed = (speed: number): void => {
    this.speed = speed
    void this.client.api.speed(speed)
  }
}
