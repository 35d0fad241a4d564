import { closest, language, languages, preferred, type Tag } from '../locales/language.svelte'
import { recall, remember } from './storage'

/* Which language the page speaks: that of its address, else the one that was chosen here before, else the browser's. */

/** As addresses have it; the core skips what begins with `page.`. */
const KEY = /[#&](?:page\.)?lang=([^&]*)/

/** An address without its language. */
export const withoutLanguage = (hash: string): string => hash.replace(/(?<=[#&])(?:page\.)?lang=[^&]*(?:&|$)/g, '').replace(/&$/, '')

/** The language that an address asks for, if it is one of ours. */
function languageOf(hash: string): Tag | undefined {
  const [, wanted] = KEY.exec(hash) ?? []
  return wanted === undefined ? undefined : closest(wanted)
}

/** The language that the page begins with. `hash`, `query`: of its address. */
export function firstLanguage(hash: string, query: string): Tag {
  const asked = new URLSearchParams(query).get('lang')
  return languageOf(hash) ?? (asked === null ? undefined : closest(asked)) ?? closest(recall('language') ?? '') ?? preferred()
}

/** Speaks the language that an opened address asks for, if it asks for one. */
export function followLanguage(hash: string): void {
  const wanted = languageOf(hash)
  if (wanted !== undefined && wanted !== language.tag) language.speak(wanted).catch((error: unknown) => console.warn(error))
}

/** What a switch leads to: the language after the present one. */
export function nextLanguage(): (typeof languages)[number] {
  const k = languages.findIndex(({ tag }) => tag === language.tag)
  // There is English at least.
  return languages[(k + 1) % languages.length] as (typeof languages)[number]
}

/** The user has chosen a language since the page was opened. */
export let isChosen = false

/** The user chooses a language. */
export function chooseLanguage(tag: Tag): Promise<void> {
  isChosen = true
  remember('language', tag)
  return language.speak(tag)
}

/** What addresses have of the language: nothing where it is the English that the browser asks for. */
export const languageKey = (): string => (language.tag === 'en' && preferred() === 'en' ? '' : `&page.lang=${language.tag}`)
