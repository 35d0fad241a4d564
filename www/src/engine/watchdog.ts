/** So often, and in milliseconds at such intervals, an answer is looked for: a machine that slept owes nobody one. */
const LOOKS = 6
const INTERVAL = 500

/** How often a thread is asked for a sign of life in which somebody's code runs, in milliseconds. */
export const HEARTBEAT = 500

/** In the words of the interpreter, which could not say it. */
export const UNSTOPPABLE = 'its code took longer than 900 ms and could not be stopped'

/** Notices when a thread does not receive messages, because it computes something that cannot be interrupted. */
export class Watchdog {
  private timer: ReturnType<typeof setInterval> | undefined
  /** Something was sent after what an answer is awaited to. */
  private more = false

  constructor(
    /** Asks for an answer; the thread answers in the order in which it is sent messages. */
    private readonly ping: () => Promise<unknown>,
    private readonly onUnresponsive: () => void,
  ) {}

  /** The thread should answer: it is about to be sent something, or something waits for it. */
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
      this.stop()
      this.onUnresponsive()
    }, INTERVAL)
    this.timer = timer
    const answered = (): void => {
      if (this.timer !== timer) return
      this.stop()
      if (this.more) this.expect()
    }
    this.ping().then(answered, answered)
  }

  /** Nothing is awaited of the thread any more. */
  stop(): void {
    clearInterval(this.timer)
    this.timer = undefined
  }
}
