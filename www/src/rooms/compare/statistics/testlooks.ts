import type { Group } from './statistics-worker'
import type { Plan } from '../plan/plan'

/** At how many seeds tests were seen, for each of those that they are of: whoever adds seeds until they differ must be told. */
export class TestLooks {
  private readonly counts = new Map<string, Set<number>>()

  /** The smaller numbers of seeds at which they were seen; what is complete is seen now. */
  at({ from, count }: Pick<Plan, 'from' | 'count'>, groups: readonly Pick<Group, 'key' | 'lots' | 'rows'>[]): number[] {
    const tested = groups.filter(({ lots }) => lots)
    if (tested.length < 2) return []
    const seen = tested.map(({ key }) => {
      const of = this.counts.get(`${from} ${key}`) ?? new Set<number>()
      this.counts.set(`${from} ${key}`, of)
      return of
    })
    if (tested.every(({ rows }) => rows.length === count)) for (const of of seen) of.add(count)
    return [...new Set(seen.flatMap((of) => [...of]))].filter((before) => before < count).sort((a, b) => a - b)
  }
}
