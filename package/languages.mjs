// What there is to say, and what other languages have of it. A language is a folder of `locales/`: files with
//   { "key": { "english": what was translated, "says": how it is said } }
// so that a text whose English has changed since is found.
import { existsSync, readdirSync, readFileSync } from 'node:fs'

const SAID = ['title', 'help', 'summary', 'note', 'units']
// Lists of texts, each of which is a value that a person reads.
const LISTED = ['words']

/** What leads to an item of a list; alternatives have one name, and are shown with different values of a parameter. */
function named(item, list) {
  const name = ({ name, role, value }) => name ?? role ?? value
  const alone = list.filter((other) => name(other) === name(item)).length === 1
  return alone || !item.when ? [name(item)] : [name(item), item.when.value]
}

/** The English texts of the catalogue, by the names that lead to them: `planners.pso.parameters.w.help`. */
export function described(catalogue) {
  const texts = {}
  const add = (key, text) => {
    if (Object.hasOwn(texts, key)) throw new Error(`${key} is said twice: ${texts[key]} and ${text}`)
    texts[key] = text
  }
  const walk = (value, path) => {
    for (const [field, inner] of Object.entries(value)) {
      if (SAID.includes(field)) add([...path, field].join('.'), inner)
      else if (LISTED.includes(field)) for (const text of inner) add([...path, field, text].join('.'), text)
      else if (Array.isArray(inner))
        for (const item of inner) {
          if (item !== null && typeof item === 'object') walk(item, [...path, field, ...named(item, inner)])
        }
      else if (inner !== null && typeof inner === 'object') walk(inner, [...path, field])
    }
  }
  walk(catalogue, [])
  return texts
}

/** The keys of messages that source code makes. */
export const made = (source) => [...source.matchAll(/\b(?:message|label|said)!\(\s*"([^"]+)"/g)].map(([, key]) => key)

/** What is said without English: keys that have none, and texts that are empty. */
export function untold(keys, texts) {
  const without = (key) => typeof texts[key] !== 'string' || texts[key].trim() === ''
  return [...new Set([...keys, ...Object.keys(texts)])].filter(without).sort()
}

/** The languages of a folder, each with its texts by key. */
export function languages(folder) {
  if (!existsSync(folder)) return {}
  const json = (path) => JSON.parse(readFileSync(path, 'utf8'))
  const read = (name) =>
    Object.assign(
      {},
      ...readdirSync(`${folder}/${name}`)
        .filter((file) => file.endsWith('.json'))
        .sort()
        .map((file) => json(`${folder}/${name}/${file}`)),
    )
  const folders = readdirSync(folder, { withFileTypes: true }).filter((entry) => entry.isDirectory())
  return Object.fromEntries(folders.map(({ name }) => [name, read(name)]))
}

/** What a language has not, what is translated from another English, and what nothing says any more: lists of keys. */
export function compare(english, translated) {
  const keys = Object.keys(english)
  const has = (key) => Object.hasOwn(translated, key)
  return {
    missing: keys.filter((key) => !has(key) || !translated[key].says),
    stale: keys.filter((key) => has(key) && translated[key].english !== english[key]),
    unused: Object.keys(translated).filter((key) => !Object.hasOwn(english, key)),
  }
}
