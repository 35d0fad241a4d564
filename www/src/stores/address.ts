/** Writes the link into the address bar: at once when the run stands still, seldom while it plays. */
const INTERVAL = 1000
const LEAST = 300

class Address {
  private last = 0
  private timer: ReturnType<typeof setTimeout> | undefined

  soon(link: string): void {
    if (performance.now() - this.last >= INTERVAL) this.write(link)
  }

  /** Browsers count how often an address changes: a burst of edits is written once. */
  now(link: string): void {
    clearTimeout(this.timer)
    const since = performance.now() - this.last
    if (since >= LEAST) this.write(link)
    else this.timer = setTimeout(() => this.write(link), LEAST - since)
  }

  private write(link: string): void {
    clearTimeout(this.timer)
    this.last = performance.now()
    if (location.hash !== link) history.replaceState(history.state, '', link)
  }
}

export const address = new Address()
