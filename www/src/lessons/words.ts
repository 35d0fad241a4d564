import { closest, language } from '../locales/language.svelte'
import type { Lesson } from './format'

/** The words of a lesson in the language of the page; what it lacks there is in the lesson's own. */
export function wordsIn(texts: Lesson['texts'], own: string): Readonly<Record<string, string>> {
  const tag = Object.keys(texts).find((one) => closest(one) === language.tag)
  return { ...texts[own], ...(tag === undefined ? {} : texts[tag]) }
}

export const wordsOf = ({ texts, language: own }: Lesson): Readonly<Record<string, string>> => wordsIn(texts, own)
