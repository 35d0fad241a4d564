import type { Inspection, Item } from 'forage-lab'
import type { Report, Supposition } from '../engine/protocol'
import type { Questions } from '../engine/host/questions'
import type { Requests } from '../engine/requests'
import type { RunClient } from '../engine/run-client'
import type { Selection } from '../scene/edits'
import type { Subject } from './subjects'

/** What is selected of the scene, and the item of the picture that is explained: a particle, an ant, a cell. */
export class SelectionStore {
  object = $state.raw<Selection | null>(null)
  inspection = $state.raw<Inspection | null>(null)
  /** What is supposed otherwise in its step, and what it would have done. */
  supposition = $state.raw<Supposition | null>(null)
  supposed = $state.raw<Inspection | null>(null)
  /** The layer whose marks and whose terms of formulas stand out. */
  lit = $state.raw<string | null>(null)

  /** What they mark on the stage; what is supposed is drawn last. */
  readonly marks = $derived.by(() => this.inspection && [...this.inspection.layers, ...(this.supposed?.layers ?? [])])

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
    this.supposition = this.supposed = this.lit = null
    this.client.want({ item, supposition: null })
  }

  /** Another draw of the same supposition has other random numbers again. */
  suppose = (name: string | null): void => {
    const { supposition } = this
    this.supposition = name === null ? null : { name, draw: supposition?.name === name ? supposition.draw + 1 : 0 }
    this.client.want({ supposition: this.supposition })
  }

  receive({ inspection, supposed }: Pick<Report, 'inspection' | 'supposed'>): void {
    this.inspection = inspection
    this.supposed = supposed
    if (!inspection) this.lit = null
  }
}
