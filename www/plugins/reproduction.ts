import { readFile } from 'node:fs/promises'
import { parse } from 'csv-parse/sync'
import type { Plugin } from 'vite'
import { COLUMNS, NUMBERS, PAPERS, type Row, VERDICTS, WORDS } from '../src/papers/row.ts'

const ID = 'virtual:reproduction'
const RESOLVED = `\0${ID}`

/**
 * Provides `virtual:reproduction`: the rows of REPRODUCTION.csv, which `forage reproduce` writes.
 * @param file where that is
 */
export function reproduction(file: string): Plugin {
  return {
    name: 'forage-reproduction',
    resolveId: (id) => (id === ID ? RESOLVED : undefined),
    async load(id) {
      if (id !== RESOLVED) return undefined
      const text = await readFile(file, 'utf8').catch(() => {
        throw new Error(`${file} is missing: \`forage reproduce\` writes it`)
      })
      this.addWatchFile(file)
      return `export const rows = ${JSON.stringify(rowsOf(text, file))}`
    },
  }
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
    const refused = (name: string, allowed: string): Error => new Error(`${file}, row ${line + 1}: ${name} is “${given[name]}”; allowed: ${allowed}`)
    for (const name of WORDS) if (given[name] === '') throw refused(name, 'a text')
    if (!PAPERS.some((paper) => paper === given['paper'])) throw refused('paper', PAPERS.join(', '))
    if (!VERDICTS.some((verdict) => verdict === given['verdict'])) throw refused('verdict', VERDICTS.join(', '))
    const numbers = NUMBERS.map((name) => {
      const value = given[name] === '' ? null : Number(given[name])
      if (value !== null && !Number.isFinite(value)) throw refused(name, 'a finite number, or nothing')
      return [name, value]
    })
    return { ...given, ...Object.fromEntries(numbers) } as Row
  })
}
