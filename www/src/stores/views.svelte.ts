/** What the page shows: one run, many, some beside each other, or what was published. */
export const VIEWS = ['stage', 'batch', 'race', 'papers'] as const
export type View = (typeof VIEWS)[number]

const PREFIX = '#view='

class Views {
  current = $state<View>('stage')

  /** The view that an address is of: `#view=batch`. Others are links of runs. */
  named(hash: string): View | undefined {
    return VIEWS.find((view) => hash === PREFIX + view)
  }
}

export const views = new Views()
