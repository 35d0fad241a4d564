import type { Questions } from '../engine/host/questions'
import type { Followers } from './followers.svelte'
import type { Follower } from './following.svelte'
import type { PlaybackStore } from './playback.svelte'
import type { SelectionStore } from './selection.svelte'

/** The robot's drive, or the arm's motion, along the result; the steps within an iteration. The run waits meanwhile. */
export class FollowStore {
  /** The run was going on when it was left. */
  private resumes = false

  constructor(
    private readonly followers: Followers,
    private readonly playback: PlaybackStore,
    private readonly selection: SelectionStore,
    private readonly api: Questions,
  ) {}

  drive = async (): Promise<void> => this.begin(await this.followers.robot(this.api))

  begin = async (follower: Follower): Promise<void> => {
    this.resumes = this.playback.playing
    this.followers.unfolded = false
    this.pause()
    await follower.begin()
  }

  /** Back to the run as it was. */
  leave = (): void => {
    this.followers.leave()
    if (this.resumes) this.playback.play()
    this.resumes = false
  }

  /** Shows this iteration step by step. */
  unfold = (): void => {
    this.followers.leave()
    this.pause()
    this.followers.unfolded = true
  }

  private pause(): void {
    if (this.playback.playing) this.playback.pause()
    this.selection.inspect(null)
  }
}
