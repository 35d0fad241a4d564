import type { Refusal } from '../engine/protocol'

/** A part of the core could not be loaded: what follows from it, in words, and what asks again. */
interface Unloaded {
  message: string
  ask(): Promise<unknown>
}

/** Messages above everything else. */
export class NoticesStore {
  text = $state('')
  unloaded = $state.raw<Unloaded | null>(null)

  /** Says what was refused; where nothing was but a part could not be loaded, `ask` is offered. */
  warn(refusal: Refusal, message: string, ask: () => Promise<unknown>): void {
    if (refusal.unloaded) this.unloaded = { message, ask }
    else this.text = message
  }

  /** Once more, after a part could not be loaded. */
  retry = async (): Promise<void> => {
    const { unloaded } = this
    await unloaded?.ask()
    // Otherwise it has failed again.
    if (this.unloaded === unloaded) this.unloaded = null
  }
}
