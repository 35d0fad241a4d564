import type { RunSetup } from '../catalogue/own'
import type { Suggestion } from 'forage-lab'
import type { Questions } from '../engine/host/questions'

/** The sizes that the planner's paper recommends for a setup. */
export class Suggested {
  value = $state.raw<Suggestion | null>(null)
  private asked = ''

  /** It hangs on the planner, the kind of scene and the parameters; cells that are painted don't change it. */
  async ask(api: Questions, setup: RunSetup, kind: string | undefined): Promise<void> {
    const key = JSON.stringify([setup.planner, kind, setup.params])
    if (key === this.asked) return
    this.asked = key
    const answer = await api.suggest(setup).catch(() => null)
    if (this.asked !== key) return
    this.value = answer?.ok ? answer.value : null
    // The thread broke down: the next run asks again.
    if (!answer) this.asked = ''
  }
}
