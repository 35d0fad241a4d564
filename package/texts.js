/* Where a catalogue has texts that people read, and what leads to each: `planners.pso.parameters.w.help`. */

const SAID = ['title', 'help', 'summary', 'note', 'units', 'source', 'evaluation']
// Lists of texts, each of which is a value that a person reads.
const LISTED = ['words']
// Lists of lines, which are indented by spaces.
const LINES = ['pseudocode']

/** What leads to an item of a list; alternatives have one name, and are shown with different values of a parameter. */
function named(item, list) {
  const name = ({ name, role, value }) => name ?? role ?? value
  const alone = list.filter((other) => name(other) === name(item)).length === 1
  return alone || !item.when ? [name(item)] : [name(item), item.when.value]
}

/** The value with each of its texts replaced by what `say(text, path)` returns, in an order that is always the same. */
function mapped(value, say, path = []) {
  if (value === null || typeof value !== 'object') return value
  if (Array.isArray(value)) return value.map((item) => (isObject(item) ? mapped(item, say, [...path, ...named(item, value)]) : item))
  const entries = Object.entries(value).map(([field, inner]) => {
    const at = [...path, field]
    if (SAID.includes(field)) return [field, say(inner, at.join('.'))]
    if (LISTED.includes(field)) return [field, inner.map((text) => say(text, [...at, text].join('.')))]
    if (LINES.includes(field)) return [field, inner.map((line, k) => line.replace(/\S.*/, (text) => say(text, [...at, k].join('.'))))]
    return [field, mapped(inner, say, at)]
  })
  return Object.fromEntries(entries)
}

const isObject = (value) => value !== null && typeof value === 'object'

/** The English texts of a catalogue, by the names that lead to them. */
export function described(catalogue) {
  const texts = {}
  mapped(catalogue, (text, key) => {
    if (Object.hasOwn(texts, key)) throw new Error(`${key} is said twice: ${texts[key]} and ${text}`)
    texts[key] = text
    return text
  })
  return texts
}

/** A catalogue in another language: `texts` are those of `locales/TAG/catalogue.json`, which belong to this version's catalogue; throws for others. */
export function translated(catalogue, texts) {
  let k = 0
  const said = mapped(catalogue, (text) => texts[k++] ?? text)
  if (k !== texts.length) throw new RangeError(`texts: ${texts.length} are not those of this catalogue, which has ${k}`)
  return said
}

/** A language that is there. */
export function languageIn(languages, tag) {
  if (!languages.includes(tag)) throw new RangeError(`language: there is no \`${tag}\`; known: ${languages.join(', ')}`)
  return tag
}
// Texts that differ in their numbers only are translated once: `{1} of {2} seeds`.
// A list of numbers is one: `with the seeds {1}`.
const ONE = '[-−]?\\d+(?:[,.]\\d+)*(?:e[-+]?\\d+)?(?![\\w}]|[,.]\\d)'
const NUMBER = new RegExp(`(?<![\\w.{])${ONE}(?: ${ONE})*`, 'g')

/** A text with its numbers replaced by `{1}`, `{2}` …, and the numbers. */
export function numbered(text) {
  const numbers = []
  return { text: text.replace(NUMBER, (number) => `{${numbers.push(number)}}`), numbers }
}

/** A text with numbers put in. */
export const filled = (text, numbers) => text.replace(/\{(\d+)\}/g, (place, k) => numbers[k - 1] ?? place)
