// English with accents, longer and between brackets.
const PLAIN = 'abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ'
const ACCENTS = 'áƀçđéƒĝĥíĵķĺɱñóþɋŕšťúṽŵẋýžÁƁÇĐÉƑĜĤÍĴĶĹṀÑÓÞɊŔŠŤÚṼŴẊÝŽ'
const letters = new Map([...PLAIN].map((letter, k) => [letter, [...ACCENTS][k]]))
/** What is no text: formulas, code, links, names of tags, numbers of figures. */
const KEPT = /\$[^$]+\$|`[^`]*`|\]\([^)]*\)|\[[A-Z][A-Z-]+\]|\{[^{}]*\}|<[^>]*>|https?:\S+/g
/** A third longer, as other languages are. */
const LONGER = 3

function inLetters(text) {
  return [...text].map((letter) => letters.get(letter) ?? letter).join('')
}

/** A text with accents. `pattern`: it is one of Fluent, whose placeholders stay. */
export function accented(text, pattern = false) {
  if (!/[A-Za-z]{2}/.test(text)) return text
  let [out, from] = ['', 0]
  const kept = pattern ? placeholders(text) : [...text.matchAll(KEPT)].map(({ index, 0: found }) => [index, index + found.length])
  for (const [begin, end] of kept) {
    out += inLetters(text.slice(from, begin)) + text.slice(begin, end)
    from = end
  }
  out += inLetters(text.slice(from))
  return `⟦${out}${'~'.repeat(Math.ceil(out.length / LONGER))}⟧`
}

/** Where a pattern has placeholders: braces, which may hold others. */
function placeholders(text) {
  const found = []
  let [depth, begin] = [0, 0]
  for (const [k, letter] of [...text].entries()) {
    if (letter === '{' && depth++ === 0) begin = k
    if (letter === '}' && --depth === 0) found.push([begin, k + 1])
  }
  return found
}

/** Texts and functions that return them, with accents. */
export function inAccents(value) {
  if (typeof value === 'string') return accented(value)
  if (typeof value === 'function') return (...given) => accented(value(...given))
  if (Array.isArray(value)) return value.map(inAccents)
  if (value instanceof RegExp || value === null || typeof value !== 'object') return value
  return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, inAccents(inner)]))
}
