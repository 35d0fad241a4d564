/*
 * For pages and bundlers. What is loaded comes over the network: `await init()` for the swarms and links, `await load('grid')` for
 * more, and `await ready(() => new Session(setup))` for whatever a call turns out to need.
 */
import { begin } from './core.js'
import { languageIn } from './texts.js'
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

export { shapes } from './core.js'
export { partsOf, reset, speakBy }

/** What the last call lacked. */
let wanted = []
const coming = new Map()

/** A promise that is made once, and once more after it failed. */
function once(key, make) {
  const known = coming.get(key)
  if (known) return known
  const made = make()
  coming.set(key, made)
  made.catch(() => coming.delete(key))
  return made
}

let serve = (_, url) => fetch(url())
/** The first part, if nobody says where it is; else it is where this file is. */
let first = () => undefined

/**
 * From where the package's files come, if not from where this one is: `serve('grid.wasm')` and `serve('locales/en/grid.json')`
 * promise responses. To be called before anything is loaded.
 */
export function serveBy(from) {
  serve = from
  first = () => from('forage_bg.wasm')
}

async function response(name, url) {
  const found = await serve(name, url)
  if (!found.ok) throw new Error(`${found.status} ${found.statusText}: ${name}`)
  return found
}

/** The compiled code of a file. */
export async function compiled(file, url = urls[file]) {
  const found = await response(`${file}.wasm`, url)
  const bytes = found.clone()
  return WebAssembly.compileStreaming(found).catch(async (error) => {
    if (found.headers.get('content-type') === 'application/wasm') throw error
    console.warn(`${file}.wasm is not served as application/wasm: it is compiled after it has come, not meanwhile.`)
    return WebAssembly.compile(await bytes.arrayBuffer())
  })
}

let ours

/** The first part, ready for others. */
function core(source) {
  ours ??= begin(source ?? first()).then(
    (exports) => {
      share(exports)
      askBy((parts, known) => {
        wanted = parts
        return known ? parts.join("', '") : undefined
      })
    },
    (error) => {
      ours = undefined
      throw error
    },
  )
  return ours
}

async function link(parts) {
  const files = filesOf(missing(parts))
  const modules = await Promise.all([...files.map((file) => once(file, () => compiled(file))), core()])
  for (const [k, file] of files.entries()) linkFile(file, modules[k])
  addParts(parts)
}

let language = 'en'
/** The language that was asked for last: it is spoken as soon as its words are there. */
let asked = 'en'
/** What says messages, by language. */
const speakers = {}
/** Where a part's words in another language are not there yet, it speaks English. */
const say = (key, given) => speakers[language]?.(key, given) ?? speakers.en?.(key, given)

/** The words of a part, while its code comes. */
function spoken(part, tag = asked) {
  return once(`words ${tag} ${part}`, async () => {
    if (!speaksOwn()) return
    const { speaker, words } = await import('./languages.js')
    const patterns = await (await response(`locales/${tag}/${part}.json`, words[tag][part])).json()
    speakers[tag] ??= speaker(tag, {})
    speakers[tag].add(patterns)
    await core()
    speakOwn(say)
  })
}

/** Has messages said in another language from now on: those of the parts that are there, and of those that come. */
export async function speakIn(tag) {
  const next = languageIn(languages, tag)
  // Parts that are on their way, too: their words were asked for in the language of before.
  const there = ['swarm', ...PARTS].filter((part) => coming.has(`words ${language} ${part}`) || isAdded(part))
  asked = next
  try {
    if (ours) await Promise.all(there.map((part) => spoken(part, next)))
  } catch (error) {
    // Parts that come later speak the language of before, too.
    if (asked === next) asked = language
    throw error
  }
  // A later call wins.
  if (asked === next) language = next
}

/** The scenes that ship with a part, while its code comes. */
const set = (part) =>
  once(`scenes ${part}`, async () => {
    if (!scenes[part]) return
    const list = await (await response(`scenes/${part}.json`, scenes[part])).json()
    await core()
    addScenes(part, list)
  })

/**
 * Loads parts of the module besides the first one: `grid`, `tour`, `arm`, `links`, `files`, `formulas`, `code`, `generators`,
 * `pictures`, `statistics`.
 * What is there already is not loaded again.
 */
export async function load(...parts) {
  const all = [...new Set(['swarm', ...parts, ...PARTS.filter(isAdded)])]
  await Promise.all([link(parts), ...all.flatMap((part) => [spoken(part), set(part)])])
}

/** Loads the code of parts, and not their words: texts are keys until `load` has been called. */
export async function loadCode(...parts) {
  await Promise.all([link(parts), ...['swarm', ...parts].map(set)])
}

/** Loads what a page needs to begin with: the swarms, and links. `source`: where the first part is, if it is not where this file is. */
export default async function init(source) {
  void core(source)
  await load('links')
}

/**
 * Calls `make`, loads what it turns out to need (a part with a planner, a kind of scene or a tool) and calls it again:
 * `const session = await ready(() => new Session(setup))`.
 */
export async function ready(make) {
  await load()
  for (;;) {
    wanted = []
    try {
      return make()
    } catch (error) {
      if (wanted.length === 0) throw error
      await load(...wanted)
    }
  }
}

/** Adds a planner in JavaScript. */
export async function register(planner) {
  const own = await import('./own.js')
  return own.register(planner, load)
}
