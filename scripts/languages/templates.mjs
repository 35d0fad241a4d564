// What the Workshop's templates say: their comments, and the texts of the planners that they describe.
import { readdirSync, readFileSync } from 'node:fs'

/** A comment of a line, or a text in quotation marks of either kind. */
const WORDS = /(?<=^ *\/\/ ).+$|(?<=^\/\*\* ).+(?= \*\/$)|(?<=\b(?:title|summary|help): (['`])).*?(?=\1)/gm

/** The templates of a folder, by the names of their files. */
export const templatesIn = (folder) =>
  readdirSync(folder).map((file) => ({ name: file.replace(/\.js$/, ''), code: readFileSync(`${folder}/${file}`, 'utf8') }))

/** All that a template says, in its order. */
export const wordsOf = (code) => [...code.matchAll(WORDS)].map(([words]) => words)

/**
 * A template in another language: what is not said there stays English.
 * @param {string} code
 * @param {(words: string) => string | undefined} say
 */
export const translated = (code, say) => code.replace(WORDS, (words) => say(words) || words)

/** The title of the planner that a template describes. */
export const titleOf = (code) => /^ {2}title: '(.*)',$/m.exec(code)?.[1] ?? ''
