/*
 * For Node. The first part is there on import; another one is read from disk when a call needs it.
 */
import { readFileSync } from 'node:fs'
import { initSync } from './glue.js'
import { speaker, words } from './languages.js'
import {
  addParts,
  addScenes,
  askBy,
  filesOf,
  isAdded,
  linkFile,
  missing,
  PARTS,
  partsOf,
  reset,
  share,
  speakBy,
  speakOwn,
  speaksOwn,
} from './loader.js'
import { languages, scenes, urls } from './parts.js'
import { languageIn } from './texts.js'

export { catalogue } from './catalogue.js'
export { shapes } from './core.js'
export { partsOf, reset, speakBy }

let language = 'en'
/** What says messages, by language. */
const speakers = {}
const say = (key, given) => speakers[language](key, given)

const read = (url) => JSON.parse(readFileSync(url()))

function addWords(part) {
  speakers[language] ??= speaker(language, {})
  speakers[language].add(read(words[language][part]))
}

/** Has messages said in another language from now on. */
export async function speakIn(tag) {
  language = languageIn(languages, tag)
  for (const part of ['swarm', ...PARTS.filter(isAdded)]) addWords(part)
}

/** Adds the words and the scenes of a part. */
function complete(part) {
  if (speaksOwn()) addWords(part)
  if (scenes[part]) addScenes(part, read(scenes[part]))
}

share(initSync({ module: readFileSync(urls.forage_bg()) }))
complete('swarm')
speakOwn(say)

/** Reads parts of the module that are not there yet: for a call that must not be the first one to do it. */
export function loadNow(...parts) {
  for (const file of filesOf(missing(parts))) linkFile(file, new WebAssembly.Module(readFileSync(urls[file]())))
  for (const part of missing(parts)) complete(part)
  addParts(parts)
}

askBy((parts) => {
  loadNow(...parts)
  return true
})

/** As in a page; here a call that needs a part reads it by itself. */
export async function load(...parts) {
  loadNow(...parts)
}

export const loadCode = load

/** As in a page; here what `make` needs is there. */
export async function ready(make) {
  return make()
}

/** In Node files are read from where they are. */
export function serveBy() {}

/** In Node everything is ready on import; this keeps code that calls `await init()` working. */
export default async function init() {}

/** Adds a planner in JavaScript. */
export async function register(planner) {
  const own = await import('./own.js')
  return own.register(planner, load)
}
