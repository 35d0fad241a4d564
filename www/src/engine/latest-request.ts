/** Asks for one thing at a time; of what is wanted meanwhile only the newest is asked for. */
export class Latest<T> {
  private busy = false
  private next: { wanted: T } | null = null

  constructor(private readonly ask: (wanted: T) => Promise<unknown>) {}

  want(wanted: T): void {
    this.next = { wanted }
    if (!this.busy) void this.go()
  }

  private async go(): Promise<void> {
    this.busy = true
    try {
      while (this.next) {
        const { wanted } = this.next
        this.next = null
        await this.ask(wanted)
      }
    } finally {
      this.busy = false
    }
  }
}
