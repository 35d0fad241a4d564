// A language for tests: English with accents, longer and between brackets. What has no accents was forgotten, what is cut off has no bracket.
//   node scripts/languages/pseudo.mjs FOLDER   makes FOLDER/en-XA of what scripts/language new has written there
import { readdirSync, writeFileSync } from 'node:fs'
import { json, write } from './folder.mjs'
import { accented } from './accented.js'

const folder = `${process.argv[2]}/en-XA`
write(`${folder}/language.json`, { name: 'Énglîsh', sign: 'XA' })
for (const part of ['messages', 'lessons', 'texts'])
  for (const file of readdirSync(`${folder}/${part}`)) {
    const entries = Object.entries(json(`${folder}/${part}/${file}`))
    const said = ([key, entry]) => [
      key,
      part === 'texts' ? accented(key) : { ...entry, says: accented(entry.english, part === 'messages') },
    ]
    write(`${folder}/${part}/${file}`, Object.fromEntries(entries.map(said)))
  }
const terms = Object.entries(json(`${folder}/glossary.json`))
const named = ([term, { english }]) => [term, { english, term: accented(term), says: accented(english) }]
write(`${folder}/glossary.json`, Object.fromEntries(terms.map(named)))
const here = new URL('.', import.meta.url).pathname
for (const file of readdirSync(`${folder}/page`).filter((name) => name.endsWith('.ts'))) {
  const name = file.slice(0, -3)
  const module = [
    `import { ${name} as english } from '${here}../../www/src/locales/en/${name}'`,
    `import { inAccents } from '${here}accented.js'`,
    `export const ${name} = inAccents(english)`,
  ]
  writeFileSync(`${folder}/page/${file}`, `${module.join('\n')}\n`)
}
