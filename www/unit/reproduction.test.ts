import { readFileSync } from 'node:fs'
import { expect, test } from 'vitest'
import { checksOf, rowsOf } from '../plugins/reproduction'
import { runOf } from '../src/papers/commands'
import { COLUMNS, MARKS, NUMBERS, PAPERS } from '../src/papers/row'

const FILE = 'REPRODUCTION.csv'
const REPORT = 'REPRODUCTION.md'
const source = readFileSync(new URL(`../../${FILE}`, import.meta.url), 'utf8')

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

test('a report without readable claims stops the build with a message that names it', () => {
  const heading = (tag: string): string => `### name: title, [${tag}] Table 2\n\n- it holds: at all: yes (1 (of 1) beside 2)\n- a note\n`
  const all = PAPERS.map(heading).join('\n')
  expect(checksOf(all, REPORT)).toEqual(
    PAPERS.map((paper) => ({ reproduction: 'name', paper, claim: 'it holds: at all', answer: 'yes', because: '1 (of 1) beside 2' })),
  )
  expect(() => checksOf(all.replace('[LTQPSO]', '[QPSO]'), REPORT)).toThrow(
    `${REPORT}: the heading “### name: title, [QPSO] Table 2” names no reproduction`,
  )
  expect(() => checksOf(all.replaceAll('yes', 'maybe'), REPORT)).toThrow(`${REPORT} checks no claim of WCPSO, LTQPSO`)
})
