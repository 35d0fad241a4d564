/** What REPRODUCTION.csv and REPRODUCTION.md hold: read when the page is built, shown by the papers' cards. */

export const PAPERS = ['WCPSO', 'LTQPSO', 'ANTBAT', 'ARM-RRT', 'WOLF-ANT'] as const
export const VERDICTS = ['reproduced', 'better', 'worse', 'not determined'] as const

export type Paper = (typeof PAPERS)[number]
export type Verdict = (typeof VERDICTS)[number]

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
export const WORDS = ['reproduction', 'table', 'row', 'measure', 'because', 'command'] as const

/** The header of the file, in its order. */
export const COLUMNS: readonly string[] = ['reproduction', 'paper', 'table', 'row', 'measure', ...NUMBERS, 'verdict', 'because', 'command']

/** A published figure, ours beside it, and what is to be thought of the two. */
export type Row = Record<(typeof WORDS)[number], string> &
  Record<(typeof NUMBERS)[number], number | null> & { paper: Paper; verdict: Verdict }

export const ANSWERS = ['yes', 'NO', 'not decided'] as const

/** Something that a paper claims, and whether the runs here bear it out. */
export interface Check {
  reproduction: string
  paper: Paper
  claim: string
  answer: (typeof ANSWERS)[number]
  /** The numbers it rests on. */
  because: string
}
