import { punctuation } from '../../locales/en/punctuation'
import type { ParameterValue } from 'forage-lab'
import type { Case, Run } from './cases'
import { PAPERS, type Paper } from './row.ts'

/** What REPRODUCTION.claims.json holds: read when the page is built. */

export const CLAIM_MARKS = ['upheld', 'refuted', 'undecided'] as const
export type ClaimMark = (typeof CLAIM_MARKS)[number]
export const ANSWERS = ['as-claimed', 'contrary', 'trivial', 'undecided'] as const
export type Answer = (typeof ANSWERS)[number]

/** A picture of a paper: which claims rest on it, or why none does. */
export interface Picture {
  name: string
  shows: string
  claims: readonly string[]
  remark: string
}

export interface PaperInfo {
  tag: Paper
  /** The Chinese title; null: not printed in the text that we have. */
  title: string | null
  english: string
  english_printed: boolean
  /** In Chinese and in Latin letters. */
  authors: readonly [string, string] | null
  affiliation: string | null
  journal: string | null
  year: number | null
  reference: string
  pictures: readonly Picture[]
}

export interface Arm {
  planner: string
  parameters: Readonly<Record<string, ParameterValue>>
  command: string
}

/** A question to runs, and the answer. */
export interface Question {
  question: string
  on: string
  /** The scene, if it is one that ships. */
  scene: string | null
  arms: readonly Arm[]
  seeds: readonly [number, number]
  n: number
  numbers: string
  test: string
  p: number | null
  corrected: number | null
  effect: string
  answer: Answer
}

export interface Claim {
  paper: Paper
  id: string
  quotation: string
  says: string
  place: string
  /** The tables of figures that belong to it, by the beginnings of their names. */
  tables: readonly string[]
  reading: string
  mark: ClaimMark
  because: string
  parts: readonly Question[]
}

/**
 * The papers and their claims; marks and tags are checked, so that the build fails rather than the page.
 * @param file its name, for what is wrong with it
 */
export function claimsOf(text: string, file: string): { papers: PaperInfo[]; claims: Claim[] } {
  const { papers = [], claims = [] } = JSON.parse(text) as { papers?: PaperInfo[]; claims?: Claim[] }
  const tags = papers.map(({ tag }) => tag)
  if (tags.join() !== PAPERS.join()) throw new Error(`${file}: its papers are “${tags.join()}”; expected: ${PAPERS.join()}`)
  for (const { id, paper, mark, parts } of claims) {
    if (!PAPERS.includes(paper)) throw new Error(`${file}, ${id}: paper is “${paper}”; allowed: ${PAPERS.join(', ')}`)
    if (!CLAIM_MARKS.includes(mark)) throw new Error(`${file}, ${id}: mark is “${mark}”; allowed: ${CLAIM_MARKS.join(', ')}`)
    for (const { answer } of parts)
      if (!ANSWERS.includes(answer)) throw new Error(`${file}, ${id}: answer is “${answer}”; allowed: ${ANSWERS.join(', ')}`)
  }
  const missing = PAPERS.filter((paper) => !claims.some((claim) => claim.paper === paper))
  if (missing.length > 0) throw new Error(`${file} has no claim of ${missing.join(', ')}`)
  return { papers, claims }
}

/** How many claims have each mark. */
export const marked = (claims: readonly Claim[]): [ClaimMark, number][] =>
  CLAIM_MARKS.map((mark) => [mark, claims.filter((claim) => claim.mark === mark).length])

/** A question’s runs, to open them; null where its scenes are generated. */
export function caseOf({ scene, arms, seeds }: Question): Case | null {
  if (scene === null || arms.length === 0) return null
  return { scene, runs: arms.map(({ planner, parameters }): Run => ({ planner, params: parameters, seed: seeds[0] })) }
}

/** What all planners of a question have in common, and what each has alone: `name value`. */
export function told({ arms }: Question, shown: (value: ParameterValue) => string): { own: string[]; common: string } {
  const line = (pairs: [string, ParameterValue][]): string => punctuation.list(pairs.map(([name, value]) => `${name} ${shown(value)}`))
  const isCommon = (name: string, value: ParameterValue): boolean => arms.every(({ parameters }) => parameters[name] === value)
  const pairs = (arm: Arm, common: boolean): [string, ParameterValue][] =>
    Object.entries(arm.parameters).filter(([name, value]) => isCommon(name, value) === common)
  const [first] = arms
  return { own: arms.map((arm) => line(pairs(arm, false))), common: first ? line(pairs(first, true)) : '' }
}
