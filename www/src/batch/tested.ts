import { compare } from 'forage-lab'
import type { Friedman, Group, Pair } from 'forage-lab'
import type { Row } from './plan'

/* Tests ask whether chance alone explains a difference: deterministic planners take no part in them. */

/** Without lots every seed gives the same run. */
export const drawsLots = (rows: readonly Row[]): boolean => rows.length < 2 || rows.some(({ record }) => !record.deterministic)

/** Two groups beside each other; without a test where one of them is deterministic. */
export interface TestedPair extends Omit<Pair, 'u' | 'p' | 'corrected'> {
  p: number | null
  corrected: number | null
}

/** Only those that draw lots have a rank. */
export interface TestedRanks extends Omit<Friedman, 'ranks'> {
  ranks: (number | null)[]
}

interface Drawn extends Group {
  lots: boolean
}

const placesOf = (groups: readonly Drawn[]): number[] => groups.flatMap(({ lots }, at) => (lots ? [at] : []))

/** Of all pairs, as they were compared, those that can be tested; corrected for so many only. */
export function testedPairs(all: readonly Pair[], groups: readonly Drawn[]): TestedPair[] {
  const places = placesOf(groups)
  const tests = new Map(
    (places.length < 2 ? [] : compare(groups.filter(({ lots }) => lots)).pairs).map((pair) => [
      `${places[pair.first]} ${places[pair.second]}`,
      pair,
    ]),
  )
  return all.map(({ first, second, better }) => {
    const test = tests.get(`${first} ${second}`)
    return { first, second, better, p: test?.p ?? null, corrected: test?.corrected ?? null }
  })
}

/** In all groups the same place stands for the same seed. */
export function testedRanks(groups: readonly Drawn[]): TestedRanks | null {
  const places = placesOf(groups)
  const drawn = groups.filter(({ lots }) => lots)
  if (drawn.length < 2 || !drawn[0]?.values.length) return null
  const { friedman } = compare(drawn)
  return friedman && { ...friedman, ranks: groups.map((_, at) => friedman.ranks[places.indexOf(at)] ?? null) }
}
