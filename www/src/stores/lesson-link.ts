import { packed } from '../lessons/link'
import type { Lab } from './lab.svelte'
import { wordsOf } from '../lessons/words'
import { lessonOf } from './lesson.svelte'
import { DRAFT, OPENED } from './lesson-address'

/** The lesson that is read beside a lab's run, as an address that others can open; null: none is. */
export async function lessonLink(lab: Lab): Promise<{ address: string; title: string } | null> {
  const { lesson, source, step } = lessonOf(lab)
  if (!lesson) return null
  // What only this browser has goes with the address.
  const name = source === DRAFT || source.startsWith(OPENED) ? await packed(JSON.stringify(lesson)) : source
  const title = wordsOf(lesson)[lesson.title] ?? lesson.name
  return { address: `#lesson=${name}${step ? `&step=${step.name}` : ''}`, title }
}
