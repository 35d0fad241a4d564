/** What REPRODUCTION.csv and REPRODUCTION.md hold: read when the page is built, shown by the papers' cards. */

export const PAPERS = ['WCPSO', 'LTQPSO', 'ANTBAT', 'ARM-RRT', 'WOLF-ANT'] as const
export type Paper = (typeof PAPERS)[number]

/** The marks of a figure, of each kind the nearest to the paper first. */
export const MARKS = {
  value: ['same digits', 'no significant difference', 'same power of ten', 'differs'],
  ranking: ['same', 'partly', 'reversed', 'undecided'],
  basis: ['printed', 'our reconstruction', 'fitted', 'machine-dependent'],
  source: ['consistent', 'doubtful', 'impossible as printed'],
} as const

export type MarkKind = keyof typeof MARKS
export type MarkOf<K extends MarkKind> = (typeof MARKS)[K][number]
/** In the order of the file. */
export const KINDS = Object.keys(MARKS) as MarkKind[]

export interface Marked<K extends MarkKind> {
  mark: MarkOf<K>
  /** The numbers it rests on. */
  because: string
}
/** Null where there is nothing to compare or to check. */
export type Marks = { [K in MarkKind]: Marked<K> | null }

export const NUMBERS = [
  'published_best',
  'published_mean',
  'published_std',
  'published_runs',
  'best',
  'mean',
  'std',
  'median',
  'runs',
] as const
/** What must not be empty. */
export const WORDS = ['reproduction', 'table', 'row', 'measure', 'command'] as const

/** The header of the file, in its order. */
export const COLUMNS: readonly string[] = [
  'reproduction',
  'paper',
  'table',
  'row',
  'measure',
  'lower_is_better',
  ...NUMBERS,
  ...KINDS.flatMap((kind) => [kind, `${kind}_because`]),
  'command',
]

/** A published figure, ours beside it, and the marks that compare the two. */
export type Row = Record<(typeof WORDS)[number], string> &
  Record<(typeof NUMBERS)[number], number | null> & { paper: Paper; lower_is_better: boolean; marks: Marks }
