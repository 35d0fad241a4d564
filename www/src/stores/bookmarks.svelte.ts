/** A digit goes to each. */
export const MOST_BOOKMARKS = 9

/** Iterations of a run that somebody wants to come back to, in their order. */
export class BookmarksStore {
  list = $state.raw<readonly number[]>([])
  /** Whose they are: what runs where. */
  private of = ''

  readonly full = $derived.by(() => this.list.length >= MOST_BOOKMARKS)
  has = (iteration: number): boolean => this.list.includes(iteration)

  /** Sets one, or removes the one that is there. */
  toggle = (iteration: number): void => {
    if (this.has(iteration)) this.list = this.list.filter((at) => at !== iteration)
    else if (!this.full) this.replace([...this.list, iteration])
  }

  replace(iterations: readonly number[]): void {
    this.list = [...new Set(iterations)].sort((a, b) => a - b).slice(0, MOST_BOOKMARKS)
  }

  /** Those of a link hold for its run. */
  open(iterations: readonly number[]): void {
    this.replace(iterations)
    this.of = ''
  }

  /** Another planner or another scene has others; another seed, an edit and other parameters are compared at the same iterations. */
  belong(to: string): void {
    if (this.of !== '' && this.of !== to) this.list = []
    this.of = to
  }
}
