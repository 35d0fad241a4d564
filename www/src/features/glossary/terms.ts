import { chapters } from 'virtual:glossary'

/* Terms of the glossary within a text. */

/** Chapters about the page itself: their words are in every sentence. */
const PLAIN = ['Forage']
/** Shorter names, such as 粒子, are within too many other words. */
const LEAST = 3
const HAN = /[\u3400-\u9fff]/

/** How a text may name a term: `particle swarm optimization (PSO)` by its name and by its letters. */
const namesOf = (term: string): string[] => {
  const [, name = term, letters] = /^(.*?)(?: ?[(（](.+)[)）])?$/.exec(term) ?? []
  return [name, ...(letters && /^[A-Z]{3,}/.test(letters) ? [letters] : [])]
}

const escaped = (text: string): string => text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&')

/** What finds terms in the texts of a language, and which term each name is of. */
interface Finder {
  pattern: RegExp
  keys: ReadonlyMap<string, string>
}

const finders = new Map<string, Finder>()

function finderOf(tag: string): Finder {
  const known = finders.get(tag)
  if (known) return known
  const keys = new Map<string, string>()
  for (const { said: chapter, terms } of chapters) {
    if (PLAIN.includes(chapter.en?.[0] ?? '')) continue
    for (const { said } of terms)
      for (const name of namesOf(said[tag]?.[0] ?? '')) {
        if (name.length >= LEAST) keys.set(name.toLowerCase(), said.en?.[0] ?? '')
      }
  }
  const names = [...keys.keys()].sort((a, b) => b.length - a.length)
  const word = (name: string): string => (HAN.test(name) ? escaped(name) : `\\b${escaped(name)}s?\\b`)
  const made = { pattern: new RegExp(names.map(word).join('|') || '(?!)', 'gi'), keys }
  finders.set(tag, made)
  return made
}

/** A piece of a text; `term`: it names this term of the glossary. */
export interface Piece {
  text: string
  term?: string
}

/** A text in pieces: each term is named once, and not if it is among `before`, to which it is added. */
export function termsIn(text: string, tag: string, before: Set<string>): Piece[] {
  const { pattern, keys } = finderOf(tag)
  const pieces: Piece[] = []
  let from = 0
  for (const { 0: found, index } of text.matchAll(pattern)) {
    const name = found.toLowerCase()
    const term = keys.get(name) ?? keys.get(name.replace(/s$/, ''))
    if (term === undefined || before.has(term)) continue
    before.add(term)
    pieces.push({ text: text.slice(from, index) }, { text: found, term })
    from = index + found.length
  }
  return [...pieces, { text: text.slice(from) }].filter((piece) => piece.text !== '')
}
