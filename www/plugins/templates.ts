import { join } from 'node:path'
import type { Plugin } from 'vite'
import { saidAt, textsOf } from '../../scripts/languages/folder.mjs'
import { templatesIn, titleOf, translated } from '../../scripts/languages/templates.mjs'
import { tagsIn } from './languages.ts'

const ID = 'virtual:templates'

/**
 * Provides `virtual:templates`: the code of each template, in English and in each other language.
 * @param folder the folder with the templates
 * @param locales the folder with a folder for each other language
 */
export function templates(folder: string, locales: string): Plugin {
  return {
    name: 'forage-templates',
    resolveId: (id) => (id === ID ? `\0${ID}` : undefined),
    load(id) {
      if (id !== `\0${ID}`) return undefined
      const texts = tagsIn(locales).map((tag) => [tag, textsOf(`${locales}/${tag}`)] as const)
      const all = templatesIn(folder).map(({ name, code }) => {
        this.addWatchFile(join(folder, `${name}.js`))
        const said = texts.map(([tag, known]) => [tag, translated(code, (words) => saidAt(known[words], `templates.${name}`))] as const)
        const codes = [['en', code] as const, ...said]
        return [name, Object.fromEntries(codes.map(([tag, own]) => [tag, { title: titleOf(own), code: own }]))] as const
      })
      return `export const templates = JSON.parse(${JSON.stringify(JSON.stringify(Object.fromEntries(all)))})`
    },
  }
}
