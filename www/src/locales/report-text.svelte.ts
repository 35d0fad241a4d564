import { filled, numbered } from 'forage-lab/texts'
import { load } from 'virtual:languages'
import { language } from './language.svelte'

let words = $state.raw<{ tag: string; texts: Readonly<Record<string, string>> }>({ tag: 'en', texts: {} })

/** Loads how the language of the page says what `forage reproduce` wrote. To be called in an effect: it follows the language. */
export async function loadReportTexts(): Promise<void> {
  const { tag } = language
  const texts = (await load[tag]?.report()) ?? {}
  if (tag === language.tag) words = { tag, texts }
}

/** A text that `forage reproduce` wrote, in the language of the page. */
export function reportText(text: string): string {
  if (words.tag === 'en') return text
  const { text: pattern, numbers } = numbered(text)
  const said = words.texts[pattern]
  return said ? filled(said, numbers) : text
}
