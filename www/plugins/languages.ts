import { readdirSync, readFileSync } from 'node:fs'
import type { Plugin } from 'vite'

const ID = 'virtual:languages'
const TEXTS = 'virtual:language-texts/'
const FIRST = 'virtual:language-first/'
/** The modules of texts that the first view has. */
const FIRST_VIEW = ['common', 'learn', 'punctuation']

/** How a language calls itself. */
interface Named {
  name: string
  sign: string
}

/** The tags of the languages that have a folder. */
export const tagsIn = (locales: string): string[] =>
  readdirSync(locales, { withFileTypes: true })
    .filter((entry) => entry.isDirectory())
    .map(({ name }) => name)
    .sort()

/**
 * Provides `virtual:languages`: which languages there are, and where the words of each come from, loaded when it is spoken.
 * @param locales the folder with a folder for each language besides English
 * @param core the package, with the words of the catalogue
 */
export function languages(locales: string, core: string): Plugin {
  const tags = tagsIn(locales)
  const named = (tag: string): Named => JSON.parse(readFileSync(`${locales}/${tag}/language.json`, 'utf8')) as Named
  const modules = (tag: string): string[] => readdirSync(`${locales}/${tag}/page`).filter((file) => file.endsWith('.ts'))
  return {
    name: 'forage-languages',
    resolveId: (id) => (id === ID || id.startsWith(TEXTS) || id.startsWith(FIRST) ? `\0${id}` : undefined),
    load(id) {
      if (id === `\0${ID}`) {
        const all = [{ tag: 'en', name: 'English', sign: 'EN' }, ...tags.map((tag) => ({ tag, ...named(tag) }))]
        const words = tags.map(
          (tag) => `'${tag}': {
  first: () => import('${FIRST}${tag}').then((module) => ({ ...module })),
  texts: () => import('${TEXTS}${tag}').then((module) => ({ ...module })),
  report: () => import('${locales}/${tag}/texts/papers.json').then((module) => module.default),
  catalogue: () => import('${core}/locales/${tag}/catalogue.json').then((module) => module.default),
}`,
        )
        return `export const languages = ${JSON.stringify(all)}\nexport const load = {${words.join(',\n')}}`
      }
      const exported = (tag: string, files: readonly string[]): string =>
        files.map((file) => `export * from '${locales}/${tag}/page/${file}'`).join('\n')
      if (id.startsWith(`\0${TEXTS}`)) {
        const tag = id.slice(TEXTS.length + 1)
        return exported(tag, modules(tag))
      }
      if (id.startsWith(`\0${FIRST}`)) {
        const names = FIRST_VIEW.map((name) => `${name}.ts`)
        return exported(id.slice(FIRST.length + 1), names)
      }
      return undefined
    },
  }
}
