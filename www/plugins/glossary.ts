import { existsSync, readFileSync } from 'node:fs'
import type { Plugin } from 'vite'
import { glossaryOf } from '../../scripts/languages/glossary.mjs'
import { tagsIn } from './languages.ts'

const ID = 'virtual:glossary'

type Entries = Record<string, { term: string; says: string }>

/** Without what Markdown needs. */
const plain = (text: string): string => text.replace(/\\(?=[*_|])/g, '')

/**
 * Provides `virtual:glossary`: the terms of the field by chapters, in English and in each other language.
 * @param file the glossary in English
 * @param locales the folder with a folder for each other language
 */
export function glossary(file: string, locales: string): Plugin {
  return {
    name: 'forage-glossary',
    resolveId: (id) => (id === ID ? `\0${ID}` : undefined),
    load(id) {
      if (id !== `\0${ID}`) return undefined
      this.addWatchFile(file)
      const others = tagsIn(locales)
        .filter((tag) => existsSync(`${locales}/${tag}/glossary.json`))
        .map((tag) => [tag, JSON.parse(readFileSync(`${locales}/${tag}/glossary.json`, 'utf8')) as Entries] as const)
      const said = (key: string, meaning: string) =>
        Object.fromEntries([
          ['en', [plain(key), plain(meaning)]],
          ...others.map(([tag, entries]) => [tag, [plain(entries[key]?.term || key), plain(entries[key]?.says || meaning)]]),
        ])
      const chapters = glossaryOf(file).map(({ title, terms }) => ({
        said: said(title, ''),
        terms: terms.map(({ term, symbol, meaning }) => ({ symbol: plain(symbol), said: said(term, meaning) })),
      }))
      return `export const chapters = JSON.parse(${JSON.stringify(JSON.stringify(chapters))})`
    },
  }
}
