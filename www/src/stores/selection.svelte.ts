import type { Inspection, Item } from 'forage-lab'
import type { Questions } from '../engine/host/questions'
import type { Requests } from '../engine/requests'
import type { RunClient } from '../engine/run-client'
import type { Selection } from '../scene/edits'
import type { Subject } from './subjects'

/** What is selected of the scene, and the item of the picture that is explained: a particle, an ant, a cell. */
export class SelectionStore {
  object = $state.raw<Selection | null>(null)
  inspection = $state.raw<Inspection | null>(null)

  constructor(
    private readonly client: RunClient,
    private readonly api: Questions,
    private readonly requests: Requests<Subject>,
  ) {}

  select = (object: Selection | null): void => {
    this.object = object
  }

  /** The item that is to be explained, also before there is an answer. */
  get wanted(): Item | null {
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
}
