import type { Report } from '../engine/protocol'
import { Clock } from './clock.svelte'
import { Walk } from '../scene/steps'

/** Steps a second to choose from. */
export const PACES = [4, 16, 64] as const
/** A walk should take at most so many seconds. */
const PATIENCE = 12

/** An iteration taken apart into the steps of its ants. */
class Unfolding {
  readonly clock = new Clock(PACES[0])
  walk = $state.raw<Walk | null>(null)
  private of = ''

  /** Takes what a settled frame shows. The same iteration again changes nothing. */
  take(frame: Report, layer: number): void {
    const of = [frame.generation, frame.iteration].join()
    if (of === this.of) return
    this.of = of
    const walk = Walk.of(
      new Float32Array(frame.buffer, 0, frame.vertices),
      new Uint32Array(frame.buffer, frame.vertices * 4, frame.spans),
      layer,
    )
    this.walk = walk
    this.clock.pace = PACES.find((pace) => walk.end / pace <= PATIENCE) ?? PACES[2]
    this.clock.begin(walk.end)
  }

  leave(): void {
    this.clock.pause()
    this.walk = null
    this.of = ''
  }
}

export const unfolding = new Unfolding()
