import type { Spending } from '../../../engine/budget'
import { isWatched } from '../../../catalogue/own'
import { Aborted, pool } from '../../../engine/pool'
import type { Answer } from '../../../engine/protocol'
import type { Asked } from './standing'

/** What runs spend, by key: asked of the core once. */
export class Spendings {
  private known = $state.raw<Readonly<Record<string, Spending | string>>>({})
  private readonly asked = new Map<string, AbortController>()

  of(key: string): Spending | undefined {
    const found = this.known[key]
    return typeof found === 'string' ? undefined : found
  }

  /** What the core said to runs that it refused. */
  refusalOf(key: string): string | undefined {
    const found = this.known[key]
    return typeof found === 'string' ? found : undefined
  }

  /** Asks for those that are not known, and no longer for others: to begin a run may take long. `told`: something is known that was not. */
  ask(wanted: readonly Asked[], told: () => void): void {
    for (const [key, controller] of this.asked) if (!wanted.some((one) => one.key === key)) controller.abort()
    for (const { key, setup } of wanted) {
      if (key in this.known || this.asked.has(key)) continue
      const controller = new AbortController()
      this.asked.set(key, controller)
      void pool()
        .run<Answer<Spending | null>>((api) => api.spends(setup), { signal: controller.signal, watched: isWatched(setup) })
        .then((answer) => (answer.ok ? answer.value : answer.refusal.message))
        .catch((error: unknown) => (error instanceof Aborted ? null : error instanceof Error ? error.message : String(error)))
        .then((found) => {
          this.asked.delete(key)
          // What was called off is asked again if it is wanted by now.
          if (found !== null && !controller.signal.aborted) this.known = { ...this.known, [key]: found }
          told()
        })
    }
  }
}
