// Languages: what is to be translated, and what is missing. Called by scripts/language.
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { english } from './english.mjs'
import { compare, fileOf, isPlace, json, languageOf, tagsOf, write } from './folder.mjs'
import { skeletonOf } from './page.mjs'

const root = fileURLToPath(new URL('../..', import.meta.url))
const locales = process.env.LOCALES ?? `${root}/locales`
const [command, tag, ...keys] = process.argv.slice(2)
const fail = (text) => {
  console.error(text)
  process.exit(2)
}
const source = english(process.env.FORAGE)
const folder = `${locales}/${tag}`

/** An entry for each key: what there is, or an empty one. */
const completed = (texts, known, empty) => Object.fromEntries(Object.entries(texts).map(([key, text]) => [key, known[key] ?? empty(text)]))

/** A text without the places that there are no longer. */
const placed = (entry, paths) =>
  typeof entry === 'string' ? entry : Object.fromEntries(Object.entries(entry).filter(([place]) => isPlace(place, paths)))

/** Adds what is missing, with nothing said, and removes what is not used: every file in the order of the English. */
function update() {
  const { messages, texts } = languageOf(folder)
  const put = (part, entries) => {
    mkdirSync(`${folder}/${part.split('/')[0]}`, { recursive: true })
    write(`${folder}/${part}.json`, entries)
  }
  const byFile = {}
  for (const [key, text] of Object.entries(source.messages)) {
    byFile[fileOf(key)] ??= {}
    byFile[fileOf(key)][key] = text
  }
  const keyed = (text) => ({ english: text, says: '' })
  for (const [file, list] of Object.entries(byFile)) put(`messages/${file}`, completed(list, messages, keyed))
  const used = new Set(Object.values(source.texts).flat())
  for (const [text, said] of Object.entries(texts)) {
    const rest = placed(said, source.paths)
    if (!used.has(text) || JSON.stringify(rest) !== JSON.stringify(said)) console.log(`removed: ${JSON.stringify({ [text]: said })}`)
    texts[text] = rest
  }
  for (const [file, list] of Object.entries(source.texts))
    put(
      `texts/${file}`,
      completed(Object.fromEntries(list.map((text) => [text, text])), texts, () => ''),
    )
  for (const [name, list] of Object.entries(source.lessons)) {
    const path = `${folder}/lessons/${name}.json`
    put(`lessons/${name}`, completed(list, existsSync(path) ? json(path) : {}, keyed))
  }
  const named = (meaning) => ({ english: meaning, term: '', says: '' })
  write(`${folder}/glossary.json`, completed(source.glossary, languageOf(folder).glossary, named))
  if (!existsSync(`${folder}/language.json`)) write(`${folder}/language.json`, { name: tag, sign: tag.slice(0, 2) })
  for (const file of readdirSync(`${folder}/lessons`)) if (!source.lessons[file.slice(0, -5)]) rmSync(`${folder}/lessons/${file}`)
  mkdirSync(`${folder}/page`, { recursive: true })
  const pages = `${root}/www/src/locales/en`
  for (const file of readdirSync(pages)) {
    const path = `${folder}/page/${file}`
    if (!existsSync(path))
      write(path, skeletonOf(readFileSync(`${pages}/${file}`, 'utf8'), `../../../www/src/locales/en/${file.slice(0, -3)}`))
  }
  if (!existsSync(`${folder}/page/english.json`)) write(`${folder}/page/english.json`, {})
}

/** Says that translations are of today's English: of all keys, or of those that begin as one that is given. */
function accept() {
  const language = languageOf(folder)
  const wanted = (key, part) => keys.length === 0 || keys.some((begin) => key.startsWith(begin) || `${part}: ${key}`.startsWith(begin))
  const renewed = (part, texts) => {
    const path = `${folder}/${part}.json`
    if (!existsSync(path)) return
    const entries = json(path)
    for (const [key, entry] of Object.entries(entries))
      if (wanted(key, part.replace(/^messages\/.*/, 'messages')) && texts[key] !== undefined) entry.english = texts[key]
    write(path, entries)
  }
  for (const file of readdirSync(`${folder}/messages`)) renewed(`messages/${file.slice(0, -5)}`, source.messages)
  for (const [name, texts] of Object.entries(source.lessons)) renewed(`lessons/${name}`, texts)
  const terms = json(`${folder}/glossary.json`)
  for (const [term, entry] of Object.entries(terms)) if (wanted(term, 'glossary')) entry.english = source.glossary[term] ?? entry.english
  write(`${folder}/glossary.json`, terms)
  const own = { ...language.page.exported, ...language.page.helpers }
  const entries = Object.entries({ ...source.page.exported, ...source.page.helpers }).filter(([key]) => Object.hasOwn(own, key))
  const kept = language.pageEnglish
  write(
    `${folder}/page/english.json`,
    Object.fromEntries(entries.map(([key, text]) => [key, wanted(key, 'page') ? text : (kept[key] ?? '')])),
  )
}

/** Lists what a language lacks. */
function check(name) {
  const found = compare(source, languageOf(`${locales}/${name}`))
  for (const [kind, list] of Object.entries(found)) for (const key of list) console.log(`${name}: ${kind}: ${key}`)
  return Object.values(found).every((list) => list.length === 0)
}

if (command === 'check') {
  if (tag && !existsSync(folder)) fail(`There is no folder locales/${tag}; there are: ${tagsOf(locales).join(', ')}`)
  const all = (tag ? [tag] : tagsOf(locales)).map(check)
  if (all.includes(false)) process.exitCode = 1
} else if (!/^[a-z]{2,3}(-[A-Za-z0-9]{2,8})*$/.test(tag ?? '')) {
  fail('usage: scripts/language new|update|accept TAG, or scripts/language check [TAG]. TAG is a language tag such as `de` or `pt-BR`.')
} else if (command === 'new') {
  if (existsSync(folder)) fail(`locales/${tag} is there already: scripts/language update ${tag}`)
  update()
} else if (!existsSync(folder)) {
  fail(`There is no folder locales/${tag}: scripts/language new ${tag}`)
} else if (command === 'update') update()
else if (command === 'accept') accept()
else fail(`${command}: it must be new, update, accept or check`)
