import { unlessGone } from './questions'

/** Answers that changes wait for. Each is listed until it was acted on. */
export class Awaited {
  private list = $state.raw<readonly Promise<void>[]>([])
  readonly any = $derived(this.list.length > 0)

  /** Asks something that a change depends on, and makes the change. */
  add<T>(ask: () => Promise<T>, change: (answer: T) => void): Promise<void> {
    const changed = ask()
      .then(change)
      .catch((error: unknown) => void unlessGone(error))
    this.list = [...this.list, changed]
    return changed.finally(() => (this.list = this.list.filter((other) => other !== changed)))
  }

  /** Resolves when none is waited for. */
  async all(): Promise<void> {
    while (this.list.length > 0) await Promise.allSettled(this.list)
  }

  forget(): void {
    this.list = []
  }
}
