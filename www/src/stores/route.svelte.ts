/** What the page shows: one run, many, some beside each other, or what was published. */
export const VIEWS = ['stage', 'batch', 'race', 'papers'] as const
export type View = (typeof VIEWS)[number]

const PREFIX = '#view='
/** While a run plays, its link is written seldom, in milliseconds. Browsers count how often an address changes: a burst of edits is written once. */
const INTERVAL = 3000
const LEAST = 300

/** The view that an address is of: `#view=batch`. Others are links of runs. */
const viewOf = (hash: string): View | undefined => VIEWS.find((view) => hash === PREFIX + view)

/** What is shown, and its address. Nothing else writes the address. */
class Route {
  view = $state<View>(viewOf(location.hash) ?? 'stage')
  /** The newest link of the run, and what is added to it: how the page shows the run. */
  private link = ''
  added = ''
  private last = 0
  private timer: ReturnType<typeof setTimeout> | undefined
  /** Grows with each link that is opened from the address: entries of the history with this number are of the run that is here. */
  private opened = Date.now()

  /** The link that the page was opened on, if it was one. */
  get first(): string | null {
    return location.hash.length > 1 && !viewOf(location.hash) ? location.hash : null
  }

  /** The run is what is looked at. */
  get watched(): boolean {
    return this.view === 'stage'
  }

  /** Shows another view. The one of before is a step back. */
  go = (view: View): void => {
    if (view === this.view) return
    this.view = view
    clearTimeout(this.timer)
    history.pushState(this.mark, '', view === 'stage' ? this.address || '#' : PREFIX + view)
  }

  /** The run's link: at once where it stays, seldom while it plays. */
  write(link: string, when: 'now' | 'soon'): void {
    this.link = link
    if (this.view !== 'stage') return
    const since = performance.now() - this.last
    if (when === 'soon') {
      if (since >= INTERVAL) this.replace()
      return
    }
    this.replaceSoon(LEAST - since)
  }

  /** Keys of the page that are added to the run's link. */
  add(keys: string): void {
    if (keys === this.added) return
    this.added = keys
    if (this.link !== '') this.replaceSoon(LEAST)
  }

  private get address(): string {
    return this.link === '' ? '' : this.link + this.added
  }

  private replaceSoon(wait: number): void {
    clearTimeout(this.timer)
    if (wait <= 0) this.replace()
    else this.timer = setTimeout(() => this.replace(), wait)
  }

  private replace(): void {
    clearTimeout(this.timer)
    this.last = performance.now()
    if (this.view === 'stage' && location.hash !== this.address) history.replaceState(this.mark, '', this.address)
  }

  /** The address is another one: by the browser's buttons, or because somebody wrote it. Returns the link that is to be opened. */
  follow(hash: string): string | null {
    const view = viewOf(hash)
    this.view = view ?? 'stage'
    if (view) return null
    if (this.link !== '' && (history.state as typeof this.mark | null)?.opened === this.opened) {
      this.replace()
      return null
    }
    this.opened += 1
    return hash.length > 1 ? hash : null
  }

  private get mark(): { opened: number } {
    return { opened: this.opened }
  }
}

export const route = new Route()
