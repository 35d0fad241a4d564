import type { Questions } from '../engine/host/questions'
import type { Report } from '../engine/protocol'
import { Clock } from './clock.svelte'
import { perLab } from './context.svelte'
import { Walk } from '../scene/steps'

/** Steps a second to choose from. */
export const PACES = [4, 16, 64] as const
/** A walk should take at most so many seconds. */
const PATIENCE = 12

/** An iteration taken apart into the steps of its ants. */
class UnfoldingStore {
  readonly clock = new Clock(PACES[0])
  walk = $state.raw<Walk | null>(null)
  private of = ''

  /** Takes what a report is of, from the layer of this number. The same iteration again changes nothing. */
  async take({ generation, iteration }: Report, layer: number, { pieces }: Pick<Questions, 'pieces'>): Promise<void> {
    const of = [generation, iteration].join()
    if (of === this.of) return
    this.of = of
    const answer = await pieces(layer)
    // Meanwhile it is another one.
    if (this.of !== of) return
    const found = answer.ok ? answer.value : null
    if (!found?.result || [found.generation, found.iteration].join() !== of) {
      this.of = ''
      return
    }
    const walk = Walk.of(found.result)
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

export const unfoldingOf = perLab(() => new UnfoldingStore())
