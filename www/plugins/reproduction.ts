import { readFile } from 'node:fs/promises'
import { join } from 'node:path'
import { parse } from 'csv-parse/sync'
import type { Plugin } from 'vite'
import { claimsOf } from '../src/rooms/papers/claims.ts'
import { COLUMNS, KINDS, MARKS, NUMBERS, PAPERS, type Row, WORDS } from '../src/rooms/papers/row.ts'

const ID = 'virtual:reproduction'
const RESOLVED = `\0${ID}`

/**
 * Provides `virtual:reproduction`: what `forage reproduce` wrote, the figures' rows, the papers and their claims.
 * @param folder where REPRODUCTION.csv and REPRODUCTION.claims.json are
 */
export function reproduction(folder: string): Plugin {
  return {
    name: 'forage-reproduction',
    resolveId: (id) => (id === ID ? RESOLVED : undefined),
    async load(id) {
      if (id !== RESOLVED) return undefined
      const [rows, claimed] = await Promise.all([
        reading(folder, 'REPRODUCTION.csv', rowsOf),
        reading(folder, 'REPRODUCTION.claims.json', claimsOf),
      ])
      for (const { path } of [rows, claimed]) this.addWatchFile(path)
      const { papers, claims } = claimed.found
      return Object.entries({ rows: rows.found, papers, claims })
        .map(([name, value]) => `export const ${name} = ${JSON.stringify(value)}`)
        .join('\n')
    },
  }
}

async function reading<T>(folder: string, name: string, of: (text: string, file: string) => T): Promise<{ path: string; found: T }> {
  const path = join(folder, name)
  const text = await readFile(path, 'utf8').catch(() => {
    throw new Error(`${path} is missing: \`forage reproduce\` writes it`)
  })
  return { path, found: of(text, name) }
}

/**
 * What the file says, each row checked: better no page than one with figures in the wrong column.
 * @param file its name, for what is wrong with it
 */
export function rowsOf(text: string, file: string): Row[] {
  const [header = [], ...lines] = parse(text, { bom: true }) as string[][]
  const wrong = header.findIndex((name, k) => name !== COLUMNS[k])
  if (wrong >= 0 || header.length !== COLUMNS.length) {
    const at = wrong >= 0 ? `column ${wrong + 1} is “${header[wrong]}”` : `${header.length} columns`
    throw new Error(`${file}: ${at}; the columns are ${COLUMNS.join(',')}`)
  }
  if (lines.length === 0) throw new Error(`${file} has no rows`)
  return lines.map((cells, line) => {
    const given = Object.fromEntries(COLUMNS.map((name, k) => [name, cells[k] ?? '']))
    const refused = (name: string, allowed: string): Error =>
      new Error(`${file}, row ${line + 1}: ${name} is “${given[name]}”; allowed: ${allowed}`)
    for (const name of WORDS) if (given[name] === '') throw refused(name, 'a text')
    if (!PAPERS.some((paper) => paper === given.paper)) throw refused('paper', PAPERS.join(', '))
    if (!['yes', 'no'].includes(given.lower_is_better ?? '')) throw refused('lower_is_better', 'yes, no')
    const marks = KINDS.map((kind) => {
      const [mark, because] = [given[kind] ?? '', given[`${kind}_because`] ?? '']
      // Every figure rests on something.
      if (mark === '' && because === '' && kind !== 'basis') return [kind, null]
      if (!MARKS[kind].some((known) => known === mark)) throw refused(kind, MARKS[kind].join(', '))
      if (because === '') throw refused(`${kind}_because`, 'a text')
      return [kind, { mark, because }]
    })
    const numbers = NUMBERS.map((name) => {
      const value = given[name] === '' ? null : Number(given[name])
      if (value !== null && !Number.isFinite(value)) throw refused(name, 'a finite number, or nothing')
      return [name, value]
    })
    const words = Object.fromEntries([...WORDS, 'paper'].map((name) => [name, given[name]]))
    const lower_is_better = given.lower_is_better === 'yes'
    return { ...words, lower_is_better, ...Object.fromEntries(numbers), marks: Object.fromEntries(marks) } as Row
  })
}
