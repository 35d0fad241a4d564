import type { Drive } from 'forage-lab'
import type { Questions } from '../engine/host/questions'
import type { Clock } from './clock.svelte'
import type { Follower, Following } from './following.svelte'
import type { Track } from '../scene/track'

/** How many times as fast as the robot a drive is shown. */
const PACE = 4

/** Times beside that of the run: of those who follow its result, each from its first time on, and of an iteration's steps. */
export class Followers {
  /** The robot. */
  driving = $state.raw<Following<Drive, Track> | null>(null)
  /** The arm. */
  motion = $state.raw<Follower | null>(null)

  /** An iteration is shown step by step. */
  unfolded = $state(false)
  /** The one that the stage's keys are for, and the way back. */
  beside = $state.raw<{ clock: Clock; leave(): void } | null>(null)

  private get all(): Follower[] {
    return [this.driving, this.motion].filter((follower) => follower !== null)
  }

  /** The robot, for which the core is asked. */
  async robot(api: Questions): Promise<Follower> {
    const [{ Following }, { Track }] = await Promise.all([import('./following.svelte'), import('../scene/track')])
    this.driving ??= new Following<Drive, Track>(
      PACE,
      (params) => api.drive(params),
      (drive) => new Track(drive),
    )
    return this.driving
  }

  /** To follow another result than this would be a lie. */
  heed({ generation, iteration }: { generation: number; iteration: number }): void {
    for (const follower of this.all) {
      const { track, of } = follower
      if (track && (of.generation !== generation || of.iteration !== iteration)) follower.leave()
    }
  }

  leave(): void {
    for (const follower of this.all) follower.leave()
  }

  fold = (): void => {
    this.unfolded = false
  }

  /** Nobody follows the result, and no iteration is unfolded. */
  stop(): void {
    this.leave()
    this.unfolded = false
  }
}
