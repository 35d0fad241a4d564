import type { Measure, ValueScale } from '../../../render/plot/statistics/scale'

export type Column = 'planner' | 'seed' | 'status' | 'feasible' | 'value' | 'gap' | 'evaluations' | 'reached' | 'hash'

/** How the results are looked at: kept while other views are. */
class Looks {
  /** What the user chose; until then what suits the numbers. */
  measure = $state<Measure>()
  boxes = $state<ValueScale>()
  curves = $state<ValueScale>()
  evaluations = $state<ValueScale>('linear')

  column = $state<Column>('seed')
  descending = $state(false)
  page = $state(0)
  /** Only the runs of the entrant with this key; empty: of all. */
  filter = $state('')
  /** The link of the run that was opened from the table. */
  opened = $state('')

  sortBy = (column: Column): void => {
    this.descending = this.column === column && !this.descending
    this.column = column
    this.page = 0
  }
}

export const looks = new Looks()
