// A language is a folder of `locales/`:
//   messages/*.json  { "key": { "english": what was translated, "says": how it is said } }: patterns of Fluent, of the core and the shell
//   texts/*.json     { "English text": "how it is said" }, or { "English text": { "": how it is said, "where.it.is": another way there } }
//   lessons/*.json   { "key": { "english", "says" } }: a lesson each, by the keys of its texts
//   glossary.json    { "term": { "english": its meaning, "term": what it is called, "says": its meaning } }; chapters have no meaning
//   page/*.ts        modules like those of www/src/locales/en; page/english.json has the English that they were translated from
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { textsIn } from './page.mjs'

export function json(path) {
  try {
    return JSON.parse(readFileSync(path, 'utf8'))
  } catch (error) {
    throw new Error(`${path}: ${error.message}`, { cause: error })
  }
}
export const write = (path, value) => writeFileSync(path, typeof value === 'string' ? value : `${JSON.stringify(value, null, 2)}\n`)
const filesIn = (folder) =>
  existsSync(folder)
    ? readdirSync(folder)
        .filter((file) => file.endsWith('.json'))
        .sort()
    : []

/** The files of a folder by name, without their endings. */
const all = (folder) => Object.fromEntries(filesIn(folder).map((file) => [file.slice(0, -5), json(`${folder}/${file}`)]))

/** Files as one; what is in two of them is an error. */
function merged(files) {
  const found = {}
  for (const [file, entries] of Object.entries(files))
    for (const [key, entry] of Object.entries(entries)) {
      if (Object.hasOwn(found, key)) throw new Error(`${file}: "${key}" is in another file, too`)
      found[key] = entry
    }
  return found
}

/**
 * The texts of a language, by what they are in English.
 * @returns {Readonly<Record<string, string | Readonly<Record<string, string>>>>}
 */
export const textsOf = (folder) => merged(all(`${folder}/texts`))

/** What a language has. */
export function languageOf(folder) {
  const page = `${folder}/page`
  return {
    messages: merged(all(`${folder}/messages`)),
    texts: textsOf(folder),
    lessons: all(`${folder}/lessons`),
    glossary: existsSync(`${folder}/glossary.json`) ? json(`${folder}/glossary.json`) : {},
    page: existsSync(page) ? textsIn(page) : { exported: {}, helpers: {} },
    pageEnglish: existsSync(`${page}/english.json`) ? json(`${page}/english.json`) : {},
  }
}

/** The languages of a folder. */
export const tagsOf = (folder) =>
  existsSync(folder)
    ? readdirSync(folder, { withFileTypes: true })
        .filter((entry) => entry.isDirectory())
        .map(({ name }) => name)
        .sort()
    : []

/** How a text or a message is said where nothing else is said of the place. */
const said = (entry) => (typeof entry === 'string' ? entry : (entry?.says ?? entry?.['']))

/** Whether something of the catalogue is at a place, or below it; the empty one is everywhere. */
export const isPlace = (place, paths) => place === '' || paths.some((path) => path === place || path.startsWith(`${place}.`))

/** What is missing, translated from another English, and not used any more: lists of keys, each with what it is of. */
export function compare(english, language) {
  const found = { missing: [], stale: [], unused: [] }
  const add = (kind, part, key) => found[kind].push(`${part}: ${key}`)
  const keyed = (part, texts, entries) => {
    for (const [key, text] of Object.entries(texts)) {
      if (!said(entries[key])) add('missing', part, key)
      else if (entries[key].english !== text) add('stale', part, key)
    }
    for (const key of Object.keys(entries)) if (!Object.hasOwn(texts, key)) add('unused', part, key)
  }
  keyed('messages', english.messages, language.messages)
  const known = new Set(Object.values(english.texts).flat())
  for (const text of known) if (!said(language.texts[text])) add('missing', 'texts', text)
  for (const [text, entry] of Object.entries(language.texts)) {
    if (!known.has(text)) add('unused', 'texts', text)
    for (const [place, way] of typeof entry === 'object' ? Object.entries(entry) : [])
      if (!isPlace(place, english.paths)) add('unused', 'texts', `${text} at ${place}`)
      else if (place !== '' && !way) add('missing', 'texts', `${text} at ${place}`)
  }
  for (const [name, texts] of Object.entries(english.lessons)) keyed(`lessons/${name}`, texts, language.lessons[name] ?? {})
  for (const name of Object.keys(language.lessons)) if (!english.lessons[name]) add('unused', 'lessons', name)
  for (const [term, meaning] of Object.entries(english.glossary)) {
    const entry = language.glossary[term]
    if (!entry?.term || (meaning !== '' && !entry.says)) add('missing', 'glossary', term)
    else if (entry.english !== meaning) add('stale', 'glossary', term)
  }
  for (const term of Object.keys(language.glossary)) if (!Object.hasOwn(english.glossary, term)) add('unused', 'glossary', term)
  const { exported, helpers } = english.page
  const own = { ...language.page.exported, ...language.page.helpers }
  for (const key of Object.keys(exported)) if (!Object.hasOwn(own, key)) add('missing', 'page', key)
  // A helper that is called as the English one does the same.
  for (const [key, text] of Object.entries({ ...exported, ...helpers }))
    if (Object.hasOwn(own, key) && language.pageEnglish[key] !== text) add('stale', 'page', key)
  for (const key of Object.keys(language.page.exported)) if (!Object.hasOwn(exported, key)) add('unused', 'page', key)
  return found
}

const FILES = ['ants', 'arm', 'drive', 'error', 'files', 'scene', 'search', 'shell', 'swarm', 'tour', 'tree']

/** The file of messages that a key is in. */
export function fileOf(key) {
  const [area] = key.split('-')
  if (area === 'study') return 'shell'
  return FILES.includes(area) ? area : 'other'
}

/** How a text of the catalogue is said at its place: an object has what differs from the usual by where it does. */
export function saidAt(entry, path) {
  if (typeof entry !== 'object') return entry
  const places = Object.keys(entry).filter((place) => place !== '' && (path === place || path.startsWith(`${place}.`)))
  const [longest = ''] = places.sort((a, b) => b.length - a.length)
  return entry[longest]
}
