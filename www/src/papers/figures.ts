import { type Paper, type Row, type Verdict, VERDICTS } from './row'
import { exactly, NONE, number } from '../panels/format'

/** What one reproduction has of one table of a paper. */
export interface Group {
  id: string
  reproduction: string
  table: string
  rows: readonly Row[]
}

/** A paper's rows by the tables they belong to, in the file's order. */
export function groupsOf(rows: readonly Row[], paper: Paper): Group[] {
  const found = new Map<string, Row[]>()
  for (const row of rows) {
    if (row.paper !== paper) continue
    const key = `${row.reproduction}: ${row.table}`
    const group = found.get(key)
    if (group) group.push(row)
    else found.set(key, [row])
  }
  return [...found.values()].flatMap((group, k) => {
    const [first] = group
    return first ? [{ id: `${paper}-${k + 1}`, reproduction: first.reproduction, table: first.table, rows: group }] : []
  })
}

/** How many rows have each verdict. */
export const tally = (rows: readonly Row[]): [Verdict, number][] =>
  VERDICTS.map((verdict) => [verdict, rows.filter((row) => row.verdict === verdict).length])

const LEAST_DIGITS = 4
const MOST_DIGITS = 7
/** No figure of the papers has more. */
const PRINTED_DIGITS = 8

/** As printed: no digit more, none less, but for zeros at the end. What was worked out of printed figures is rounded. */
export function published(value: number | null): string {
  if (value === null) return NONE
  const [size, digits] = [Math.abs(value), significant(value)]
  if (digits > PRINTED_DIGITS) return number(value, LEAST_DIGITS + 1)
  return value === 0 || (size >= 1e-3 && size < 1e6) ? exactly(value) : number(value, digits + 1)
}

/** With about as many digits as what it stands beside. */
export const ours = (value: number | null, row: Row): string => number(value, digitsBeside(row))

function digitsBeside({ published_best, published_mean, published_std }: Row): number {
  const printed = [published_best, published_mean, published_std].map((value) => (value === null ? 0 : significant(value))).filter((digits) => digits <= PRINTED_DIGITS)
  return Math.min(Math.max(LEAST_DIGITS, ...printed), MOST_DIGITS)
}

const significant = (value: number): number => {
  const [mantissa = ''] = Math.abs(value).toExponential().split('e')
  return mantissa.replace('.', '').length
}
