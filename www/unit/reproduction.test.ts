import { readFileSync } from 'node:fs'
import { expect, test } from 'vitest'
import { rowsOf } from '../plugins/reproduction'
import { type Arm, caseOf, claimsOf, marked, told } from '../src/rooms/papers/claims'
import { runOf } from '../src/rooms/papers/commands'
import { groupsOf, homesOf } from '../src/rooms/papers/figures'
import { COLUMNS, MARKS, NUMBERS, PAPERS } from '../src/rooms/papers/row'

const FILE = 'REPRODUCTION.csv'
const CLAIMS = 'REPRODUCTION.claims.json'
const read = (name: string): string => readFileSync(new URL(`../../${name}`, import.meta.url), 'utf8')
const source = read(FILE)
const claimed = claimsOf(read(CLAIMS), CLAIMS)

const rows = rowsOf(source, FILE)

test('every command of a single run is parsed', () => {
  const runs = rows.filter(({ command }) => command.startsWith('forage run '))
  expect(runs.length).toBeGreaterThan(0)
  for (const { command } of rows) expect(runOf(command) !== null, command).toBe(command.startsWith('forage run '))
})

test('a malformed file stops the build with a message that names it', () => {
  const [header = '', first = ''] = source.split('\n')
  const refused = (content: string): string => {
    try {
      rowsOf(content, FILE)
    } catch (error) {
      return (error as Error).message
    }
    return 'accepted'
  }
  expect(refused(`${header}\n${first}\n`)).toBe('accepted')
  expect(refused(`${header.replace('median', 'middle')}\n${first}\n`)).toBe(
    `${FILE}: column 14 is “middle”; the columns are ${COLUMNS.join(',')}`,
  )
  expect(refused(`${header},more\n${first},\n`)).toContain('column 25 is “more”')
  expect(refused(`${header}\n`)).toBe(`${FILE} has no rows`)
  const marks = ['differs', 'far', '', '', 'printed', 'all of it', '', '']
  const line = ['r', 'WCPSO', 't', 'row', 'value', 'yes', ...NUMBERS.map(() => '1'), ...marks, 'forage']
  const given = (column: string, cell: string): string => refused(`${header}\n${line.with(COLUMNS.indexOf(column), cell).join(',')}\n`)
  expect(given('published_mean', '1e-3')).toBe('accepted')
  expect(given('paper', 'PSO')).toContain('row 1: paper is “PSO”; allowed: WCPSO, ')
  expect(given('published_mean', 'many')).toContain('row 1: published_mean is “many”; allowed: a finite number')
  expect(given('lower_is_better', 'maybe')).toContain('row 1: lower_is_better is “maybe”; allowed: yes, no')
  expect(given('value', 'good')).toContain(`row 1: value is “good”; allowed: ${MARKS.value.join(', ')}`)
  expect(given('ranking', 'same')).toContain('row 1: ranking_because is “”')
  expect(given('source_because', 'arithmetic')).toContain('row 1: source is “”')
  expect(given('basis', '')).toContain('row 1: basis is “”')
  expect(given('command', '')).toContain('row 1: command is “”')
  const [row] = rowsOf(`${header}\n${line.join(',')}\n`, FILE)
  expect(row?.marks).toEqual({
    value: { mark: 'differs', because: 'far' },
    ranking: null,
    basis: { mark: 'printed', because: 'all of it' },
    source: null,
  })
})

test('a file of claims with an unknown mark or paper stops the build with a message that names it', () => {
  const { papers, claims } = claimed
  const refused = (changed: Partial<typeof claimed>): string => {
    try {
      claimsOf(JSON.stringify({ papers, claims, ...changed }), CLAIMS)
    } catch (error) {
      return (error as Error).message
    }
    return 'accepted'
  }
  expect(refused({})).toBe('accepted')
  const [first] = claims
  if (!first) throw new Error('no claims')
  const [part] = first.parts
  if (!part) throw new Error('no questions')
  expect(refused({ papers: papers.slice(1) })).toContain(`${CLAIMS}: its papers are “LTQPSO,`)
  expect(refused({ claims: [{ ...first, paper: 'PSO' as never }] })).toContain(`${CLAIMS}, W1: paper is “PSO”; allowed: WCPSO, `)
  expect(refused({ claims: [{ ...first, mark: 'true' as never }] })).toContain('W1: mark is “true”; allowed: upheld, refuted, undecided')
  expect(refused({ claims: [{ ...first, parts: [{ ...part, answer: 'yes' as never }] }] })).toContain(
    'W1: answer is “yes”; allowed: as-claimed',
  )
  expect(refused({ claims: [first] })).toBe(`${CLAIMS} has no claim of LTQPSO, ANTBAT, ARM-RRT, WOLF-ANT`)
})

test('every picture without a claim has a reason, and every claim that a picture names exists', () => {
  const ids = claimed.claims.map(({ id }) => id)
  expect(new Set(ids).size).toBe(ids.length)
  for (const { tag, pictures } of claimed.papers)
    for (const { name, claims, remark } of pictures) {
      expect(claims.length > 0 || remark !== '', `${tag} ${name}`).toBe(true)
      for (const id of claims) expect(ids).toContain(id)
    }
  expect(marked(claimed.claims).reduce((sum, [, count]) => sum + count, 0)).toBe(ids.length)
})

test('a table is shown at the first claim that it belongs to, and only there', () => {
  for (const paper of PAPERS) {
    const groups = groupsOf(rows, paper)
    const mine = claimed.claims.filter((claim) => claim.paper === paper)
    for (const [group, home] of homesOf(groups, mine)) {
      const { table = '' } = groups.find(({ id }) => id === group) ?? {}
      expect(mine.find(({ tables }) => tables.some((name) => table.startsWith(name)))?.id).toBe(home)
    }
  }
})

test('planners of a question are told apart by what they do not have in common', () => {
  const part = claimed.claims.flatMap(({ parts }) => parts).find(({ arms }) => arms.length === 2)
  if (!part) throw new Error('no question about two planners')
  const arms: Arm[] = [
    { planner: 'wcpso', parameters: { random: 'particle', perturb: false }, command: '' },
    { planner: 'wcpso', parameters: { random: 'particle', w_law: 'linear' }, command: '' },
  ]
  expect(told({ ...part, arms }, String)).toEqual({ own: ['perturb false', 'w_law linear'], common: 'random particle' })
  expect(caseOf({ ...part, arms, scene: 'sphere', seeds: [51, 100] })?.runs.map(({ seed }) => seed)).toEqual([51, 51])
  expect(caseOf({ ...part, scene: null })).toBe(null)
})
