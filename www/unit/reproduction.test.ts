import { readFileSync } from 'node:fs'
import { expect, test } from 'vitest'
import { checksOf, rowsOf } from '../plugins/reproduction'
import { runOf } from '../src/papers/commands'
import { COLUMNS, NUMBERS, PAPERS, VERDICTS } from '../src/papers/row'

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
    `${FILE}: column 13 is “middle”; the columns are ${COLUMNS.join(',')}`,
  )
  expect(refused(`${header},more\n${first},\n`)).toContain('column 18 is “more”')
  expect(refused(`${header}\n`)).toBe(`${FILE} has no rows`)
  const line = ['r', 'WCPSO', 't', 'row', 'value', ...NUMBERS.map(() => '1'), 'better', 'why', 'forage']
  const given = (at: number, cell: string): string => refused(`${header}\n${line.with(at, cell).join(',')}\n`)
  expect(given(6, '1e-3')).toBe('accepted')
  expect(given(1, 'PSO')).toContain('row 1: paper is “PSO”; allowed: WCPSO, ')
  expect(given(6, 'many')).toContain('row 1: published_mean is “many”; allowed: a finite number')
  expect(given(14, 'good')).toContain(`row 1: verdict is “good”; allowed: ${VERDICTS.join(', ')}`)
  expect(given(16, '')).toContain('row 1: command is “”')
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
