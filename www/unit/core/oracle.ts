import type { Item, TrialRecord, UncheckedSetup } from 'forage-lab'
import { Session, type Setup, Trial } from '../../../pkg/node.js'
import type { Oracle } from '../../src/stores/lesson-truth'

/** What the page asks threads for, asked of the core itself. */
export class CoreOracle implements Oracle {
  private session: Session | undefined
  private setup = ''

  async at(setup: UncheckedSetup, iteration: number, item: Item | null) {
    const session = this.of(setup)
    session.seek(iteration)
    const { evaluations, readings, ...outcome } = session.outcome()
    return { inspection: item && session.inspect(item), readings, outcome, evaluations }
  }

  async pick(x: number, y: number, reach: number): Promise<Item | null> {
    return this.session?.pick(x, y, reach) ?? null
  }

  async trials(setup: UncheckedSetup, seeds: number, evaluations: number | null): Promise<TrialRecord[]> {
    return Array.from({ length: seeds }, (_, at) => {
      const trial = new Trial({ ...setup, seed: at + 1 } as Setup, undefined)
      while (trial.evaluations < (evaluations ?? Number.POSITIVE_INFINITY) && trial.step(1) === 'running');
      const record = trial.record()
      trial.free()
      return record
    })
  }

  /** The same run as before goes on. */
  private of(setup: UncheckedSetup): Session {
    const text = JSON.stringify(setup)
    if (this.session && text === this.setup) return this.session
    this.session?.free()
    this.session = new Session(setup as Setup)
    this.setup = text
    return this.session
  }
}
