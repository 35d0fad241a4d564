import { filled, numbered } from 'forage-lab/texts'
import { load } from 'virtual:languages'
import { language } from './language.svelte'

/** A text, or what it is by where it stands: `''` where nothing else is said. */
type Said = string | Readonly<Record<string, string>>

let words = $state.raw<{ tag: string; texts: Readonly<Record<string, Said>> }>({ tag: 'en', texts: {} })

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
  const entry = words.texts[pattern]
  const said = typeof entry === 'object' ? entry[''] : entry
  return said ? filled(said, numbers) : text
}
