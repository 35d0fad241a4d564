import { collator } from '../../../locales/language.svelte'
import type { Run, Shown } from './shown'
import type { Column } from './looks.svelte'

const of: Readonly<Record<Column, (run: Run) => number | string | null>> = {
  planner: ({ group }) => group,
  seed: ({ record }) => record.seed,
  status: ({ record }) => record.status,
  feasible: ({ record }) => (record.feasible ? 0 : 1),
  value: ({ record }) => record.value,
  gap: ({ record }) => (record.value === null ? null : record.gap),
  evaluations: ({ record }) => record.evaluations,
  reached: ({ record }) => record.reached,
  hash: ({ record }) => record.hash,
}

/** What there is none of comes last in either direction: it is worse than any number. Equals stay in the order of the plan. */
export function sortedRuns({ groups }: Shown, column: Column, descending: boolean, filter: string): Run[] {
  const key = of[column]
  const runs = groups.filter((group) => !filter || group.key === filter).flatMap((group) => group.runs)
  const sign = descending ? -1 : 1
  const { compare } = collator()
  return runs.sort((a, b) => {
    const [x, y] = [key(a), key(b)]
    if (x === null || y === null) return Number(x === null) - Number(y === null)
    if (typeof x === 'string' && typeof y === 'string') return sign * compare(x, y)
    return sign * (x < y ? -1 : x > y ? 1 : 0)
  })
}
