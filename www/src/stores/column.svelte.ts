/** What the column beside the stage holds. */
export const TABS = ['explain', 'chart', 'setup'] as const
export type Tab = (typeof TABS)[number]

/** How much of a small screen it takes. */
export const HEIGHTS = ['peek', 'half', 'full'] as const
export type Height = (typeof HEIGHTS)[number]

/** The column: a sheet from below on small screens. */
export class ColumnStore {
  tab = $state<Tab>('chart')
  height = $state<Height>('peek')

  /** Shows a tab, so that it can be read. */
  show = (tab: Tab): void => {
    this.tab = tab
    if (this.height === 'peek') this.height = 'half'
  }

  resize(by: 1 | -1): void {
    this.height = HEIGHTS[HEIGHTS.indexOf(this.height) + by] ?? this.height
  }
}
