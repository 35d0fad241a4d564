import type { Inspection } from 'forage-lab'
import { percent } from '../../text/number'

/** A cell's neighbours as they lie about it, row by row. */
export const COMPASS = ['north-west', 'north', 'north-east', 'west', '', 'east', 'south-west', 'south', 'south-east'] as const
/** The columns that a card has room for. */
const TOLD = ['tau', 'eta', 'psi', 'g', 'h', 'f']
const CHANCE = 'p'
const MOST = 3

export type Table = Inspection['table']

export const valuesOf = ({ values }: Inspection): Record<string, number> =>
  Object.fromEntries(values.map(({ name, value }) => [name, value]))

/** Whether a table is about a cell's neighbours. */
export const isCompass = ({ labels }: Table): boolean =>
  labels.length > 0 && labels.every((label) => COMPASS.some((known) => known === label))

/** What is less than this is told to be. */
const LEAST = 1e-4
export const chance = (share: number): string => (share > 0 && share < LEAST ? `< ${percent(LEAST)}` : percent(share))

/** The columns of a table that are told in short, and which is the chance. */
export function columnsOf({ columns }: Table): { told: number[]; chance: number } {
  const chance = columns.findIndex(({ name }) => name === CHANCE)
  const others = columns.map((_, at) => at).filter((at) => at !== chance)
  const known = others.filter((at) => TOLD.includes(columns[at]?.name ?? ''))
  return { told: (known.length > 0 ? known : others).slice(0, MOST), chance }
}
