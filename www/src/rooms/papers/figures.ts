import { type MarkKind, type MarkOf, MARKS, type Paper, type Row } from './row'
import { exactly, NONE, number } from '../../text/number'

/** What one reproduction has of one table of a paper. */
export interface Group {
  id: string
  reproduction: string
  table: string
  rows: readonly Row[]
}

/** Those that belong together, in the order in which they come. */
export function together<T>(items: readonly T[], name: (item: T) => string): [string, T[]][] {
  const found = new Map<string, T[]>()
  for (const item of items) {
    const group = found.get(name(item))
    if (group) group.push(item)
    else found.set(name(item), [item])
  }
  return [...found]
}

/** A paper's rows by the tables they belong to. */
export function groupsOf(rows: readonly Row[], paper: Paper): Group[] {
  const mine = rows.filter((row) => row.paper === paper)
  return together(mine, ({ reproduction, table }) => `${reproduction}: ${table}`).flatMap(([, group], k) => {
    const [first] = group
    return first ? [{ id: `${paper}-${k + 1}`, reproduction: first.reproduction, table: first.table, rows: group }] : []
  })
}

/** The claim at which each group of figures is shown: the first that it belongs to. Groups of no claim are missing. */
export function homesOf(groups: readonly Group[], claims: readonly { id: string; tables: readonly string[] }[]): Map<string, string> {
  const home = ({ table }: Group): string | undefined => claims.find(({ tables }) => tables.some((name) => table.startsWith(name)))?.id
  return new Map(
    groups.flatMap((group) => {
      const claim = home(group)
      return claim === undefined ? [] : [[group.id, claim] as const]
    }),
  )
}

/** How many rows have each mark of a kind. */
export const tally = <K extends MarkKind>(rows: readonly Row[], kind: K): [MarkOf<K>, number][] =>
  MARKS[kind].map((mark: MarkOf<K>) => [mark, rows.filter((row) => row.marks[kind]?.mark === mark).length])

const LEAST_DIGITS = 4
const MOST_DIGITS = 7
/** Of what has a power of ten: all its digits are told to those who point at it. */
const DIGITS_OF_POWERS = 4
/** No figure of the papers has more: what has was worked out of printed ones. */
const PRINTED_DIGITS = 8

const plain = (value: number): boolean => value === 0 || (Math.abs(value) >= 1e-3 && Math.abs(value) < 1e6)
const power = (value: number, digits: number): string => number(value, digits + 1)

/** As printed: no digit more, none less, but for zeros at the end. */
export function published(value: number | null): string {
  if (value === null) return NONE
  const digits = significant(value)
  if (!plain(value)) return power(value, Math.min(digits, DIGITS_OF_POWERS))
  return digits > PRINTED_DIGITS ? number(value, LEAST_DIGITS + 1) : exactly(value)
}

/** With about as many digits as what it stands beside. */
export function ours(value: number | null, { published_best, published_mean, published_std }: Row): string {
  if (value !== null && !plain(value)) return power(value, DIGITS_OF_POWERS)
  const printed = [published_best, published_mean, published_std].map((figure) => (figure === null ? 0 : significant(figure)))
  return number(value, Math.min(Math.max(LEAST_DIGITS, ...printed.filter((digits) => digits <= PRINTED_DIGITS)), MOST_DIGITS))
}

const significant = (value: number): number => {
  const [mantissa = ''] = Math.abs(value).toExponential().split('e')
  return mantissa.replace('.', '').length
}
