import type { Inspection, Item } from 'forage-lab'
import { Parameters } from './parameters.svelte'

/** The item of the picture that is explained: a particle, an ant, a cell. */
export abstract class Inspecting extends Parameters {
  inspection = $state.raw<Inspection | null>(null)
  protected item: Item | null = null

  /** The item that is to be explained, also before there is an answer. */
  get wanted(): Item | null {
    return this.item
  }

  pick = async (x: number, y: number, reach: number): Promise<void> => {
    const request = this.requests.note('inspection')
    const item = await this.api.pick(x, y, reach)
    // What was there in another run is not what is there now.
    if (!this.requests.replaced(request, 'inspection', 'run')) this.inspect(item)
  }

  inspect = (item: Item | null): void => {
    const request = this.requests.note('inspection')
    this.item = item
    if (!item) this.inspection = null
    void this.commands.watch(item, request)
  }
}
