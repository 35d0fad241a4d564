import { load } from 'virtual:lessons'
import type { Lesson } from '../../lessons/format'
import { isPacked, unpacked } from '../../lessons/link'
import { readLesson } from '../../lessons/read'
import { draft } from '../../stores/draft.svelte'
import { DRAFT, OPENED } from '../../stores/lesson-address'
import { nameOf } from '../../stores/large-links'

/** A lesson by the name that its address has; null: there is none. Throws what is wrong with one that is not the page's own. */
export async function lessonNamed(name: string): Promise<Lesson | null> {
  if (name === DRAFT) return readLesson(JSON.stringify(draft.lesson))
  if (isPacked(name)) return readLesson(await unpacked(name))
  if (name.startsWith(OPENED)) {
    const { find } = await import('../../stores/kept-scenes')
    const text = await find(name)
    return text === undefined ? null : readLesson(text)
  }
  const shipped = Object.hasOwn(load, name) ? load[name] : undefined
  return shipped ? (await shipped()).default : null
}

/** Reads a lesson's file; returns the name that its address has. */
export async function openFile(text: string): Promise<string> {
  readLesson(text)
  const name = OPENED + nameOf(text)
  const { keep } = await import('../../stores/kept-scenes')
  await keep(name, text)
  return name
}
