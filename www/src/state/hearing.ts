/** So often, and in milliseconds at such intervals, an answer is looked for: a machine that slept owes nobody one. */
const LOOKS = 6
const INTERVAL = 500

/** Notices when a thread does not receive messages, because it computes something that cannot be interrupted. */
export class Hearing {
  private timer: ReturnType<typeof setInterval> | undefined
  /** Something was said after what an answer is awaited to. */
  private more = false

  constructor(
    /** Asks whether it hears; it answers in the order in which it is told. */
    private readonly ask: () => Promise<unknown>,
    private readonly deaf: () => void,
  ) {}

  /** It is about to be told something. */
  expect(): void {
    if (this.timer) {
      this.more = true
      return
    }
    this.more = false
    let looks = 0
    const timer = setInterval(() => {
      looks += 1
      if (looks < LOOKS) return
      this.forget()
      this.deaf()
    }, INTERVAL)
    this.timer = timer
    const heard = (): void => {
      if (this.timer !== timer) return
      this.forget()
      if (this.more) this.expect()
    }
    this.ask().then(heard, heard)
  }

  /** Nothing is awaited of it any more. */
  forget(): void {
    clearInterval(this.timer)
    this.timer = undefined
  }
}
