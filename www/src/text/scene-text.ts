import { language } from '../locales/language.svelte'
import { common } from '../locales/en/common'

/** What random scenes are called: by what is made, how much of it, and the seed. */
const RANDOM = /^(.+?)((?:, .+)?), seed (\d+)$/

/** A title, a note or a unit of a scene in the language of the page: of those that ship and of random ones, others are as somebody wrote them. */
export function sceneText(text: string): string {
  const known = language.titles.get(text)
  if (known !== undefined) return known
  const [, title = '', size = '', seed = ''] = RANDOM.exec(text) ?? []
  const made = language.titles.get(title)
  return made === undefined ? text : common.random(made, size.slice(2), seed)
}
