// The terms of docs/glossary.md: its tables of terms of the field, by chapters.
import { readFileSync } from 'node:fs'

/** A term, what it is called in Chinese, which scripts/docs.mjs fills in, its symbol and its meaning. */
const ROW = /^\| (.+?) \| .*? \| (.*?) \| (.+?) \|$/
/** A chapter about the library's code, which stays English. */
const CODE = 'Library'

/** The chapters of the glossary, each with its terms. */
export function glossaryOf(path) {
  const chapters = []
  for (const line of readFileSync(path, 'utf8').split('\n')) {
    if (line.startsWith('## ')) chapters.push({ title: line.slice(3), terms: [] })
    const [, term, symbol, meaning] = ROW.exec(line) ?? []
    if (term && term !== 'term' && !term.startsWith('---')) chapters.at(-1).terms.push({ term, symbol: symbol.trim(), meaning })
  }
  return chapters.filter(({ title }) => title !== CODE)
}

/** What there is to translate: of each term its meaning; chapters are terms without one. */
export const glossaryTexts = (chapters) =>
  Object.fromEntries(chapters.flatMap(({ title, terms }) => [[title, ''], ...terms.map(({ term, meaning }) => [term, meaning])]))
