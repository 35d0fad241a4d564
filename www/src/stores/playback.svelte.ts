import type { RunSetup } from '../catalogue/own'
import { BookmarksStore } from './bookmarks.svelte'
import { stageAt } from '../catalogue/stages'
import type { Opening, Progress, Report, Target } from '../engine/protocol'
import type { Requests } from '../engine/requests'
import type { RunClient } from '../engine/run-client'
import type { Awaited } from './awaited.svelte'
import type { Followers } from './followers.svelte'
import type { RunStore } from './run.svelte'
import type { Subject } from './subjects'

/** Where the run is and where the user wants it. The engine converges to the newest. */
export class PlaybackStore {
  /** Iterations to come back to. */
  readonly bookmarks = new BookmarksStore()
  iteration = $state(0)
  playing = $state(false)
  /** Where a seek, or a new run, is on its way to. */
  target = $state<number | null>(null)
  speed = $state(30)
  /** How far a step is that takes its time. */
  underway = $state.raw<Progress | null>(null)
  /** Of the run, where it was wanted: empty before it is there. */
  hash = $state('')

  /** A new run is on its way. */
  restarting = $state(false)
  /** Steps that are taken once the changes before them are known, and the number of the newest request for one. */
  private steps: { n: number; since: number } | null = null
  /** True from a change until its first picture: the old one must not pass for the new. */
  readonly stale = $derived.by(() => this.restarting || this.run.failed || this.awaited.any)
  /** The part of the run that it is in, and how far in it. */
  readonly part = $derived.by(() => stageAt(this.run.stages, this.iteration))

  constructor(
    private readonly client: RunClient,
    private readonly requests: Requests<Subject>,
    private readonly awaited: Awaited,
    private readonly run: RunStore,
    private readonly followers: Followers,
  ) {}

  /** Starts a run; `check`: something of its setup waits for being accepted. Returns the number of this change. A seek, play or pause that was requested after request number `since` holds for it. */
  start(setup: RunSetup, check: boolean, { at, play }: Opening, since = this.requests.note('setup')): number {
    this.requested = {
      at: this.requests.replaced(since, 'iteration') ? this.requested.at : at,
      play: this.requests.replaced(since, 'playing') ? this.requested.play : play,
    }
    this.requests.note('run')
    const version = this.client.want({ start: { setup, ...this.requested, check } })
    this.showHeading()
    return version
  }

  /** Where the newest request wants the run, or its successor. */
  requested: Opening = { at: 0, play: false }

  private head(target: Target): void {
    this.requested = { at: target.at ?? this.requested.at, play: target.play }
    this.requests.note('playing', ...(target.at === undefined ? [] : (['iteration'] as const)))
    this.client.want({ target })
    this.showHeading()
  }

  /** Shows what is wanted before there is a picture of it. */
  showHeading(): void {
    const { at = null, play } = this.client.heading
    this.playing = play
    this.target = at
    this.restarting = this.client.starting
    this.hash = ''
  }

  /** The run has come farther. */
  showReport(report: Report): void {
    this.iteration = report.iteration
    this.showHeading()
    this.hash = (!this.restarting && this.client.follows(report) ? report.hash : null) ?? ''
  }

  toggle = (): void => (this.playing ? this.pause() : this.play())

  play = (): void => {
    this.followers.stop()
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
    // A new run goes where it begins all the same; another one gives up where it was going.
    const { at } = this.client.starting ? this.client.heading : {}
    if (at === undefined) this.requested.at = this.iteration
    this.head(at === undefined ? { play } : { at, play })
  }

  /** Goes to an iteration; Infinity: to the end. */
  seek = (to: number): void => {
    const iteration = Math.max(Math.round(to), 0)
    this.followers.leave()
    // How long the next run is, is not known before it has started.
    this.head({ at: this.stale ? iteration : Math.min(iteration, this.run.limit), play: false })
  }

  stepBy = (n: number): void => {
    const { steps } = this
    if (!steps && !this.awaited.any) {
      this.seek(this.place + n)
      return
    }
    this.steps = { n: n + (steps && !this.overruled(steps.since) ? steps.n : 0), since: this.requests.note() }
    if (!steps) void this.takeSteps()
  }

  /** Where a change puts the run must be known before steps can be counted from there. */
  private async takeSteps(): Promise<void> {
    await this.awaited.all()
    const { steps } = this
    this.steps = null
    if (steps && !this.overruled(steps.since)) this.seek(this.place + steps.n)
  }

  /** Nothing waits for an answer any more: the thread broke down. */
  forget(): void {
    this.awaited.forget()
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
    return this.restarting ? at : Math.min(at, this.run.limit)
  }

  setSpeed = (speed: number): void => {
    this.speed = speed
    this.client.want({ speed })
  }
}
