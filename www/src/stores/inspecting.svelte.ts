import type { Inspection, Item } from 'forage-lab'
import type { Viewport } from '../render/frame'
import { Parameters } from './parameters.svelte'

/** What is seen of the run: the item of the picture that is explained (a particle, an ant, a cell), the part of the plane, the members' numbers. */
export abstract class Inspecting extends Parameters {
  inspection = $state.raw<Inspection | null>(null)
  /** How often those want the members' numbers who read them. */
  private intervals: readonly { every: number }[] = []

  /** The item that is to be explained, also before there is an answer. */
  get wantedItem(): Item | null {
    return this.client.desired.item
  }

  pick = async (x: number, y: number, reach: number): Promise<void> => {
    const request = this.requests.note('inspection')
    const item = await this.api.pick(x, y, reach)
    // What was there in another run is not what is there now.
    if (!this.requests.replaced(request, 'inspection', 'run')) this.inspect(item)
  }

  inspect = (item: Item | null): void => {
    this.requests.note('inspection')
    if (!item) this.inspection = null
    this.client.want({ item })
  }

  /** What of the run is seen from now on. */
  see = (viewport: Viewport): void => void this.client.want({ viewport })

  /** Reports bring the members' numbers, at most each `every` milliseconds, until the returned function is called. */
  readMembers = (every: number): (() => void) => {
    const reader = { every }
    this.setReaders([...this.intervals, reader])
    return () => this.setReaders(this.intervals.filter((other) => other !== reader))
  }

  private setReaders(readers: readonly { every: number }[]): void {
    this.intervals = readers
    this.client.want({ members: readers.length > 0 ? Math.min(...readers.map(({ every }) => every)) : null })
  }
}
