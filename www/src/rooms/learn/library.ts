import { load } from 'virtual:lessons'
import type { Lesson } from '../../lessons/format'

/** A lesson by the name that its address has; null: there is none. */
export async function lessonNamed(name: string): Promise<Lesson | null> {
  const shipped = Object.hasOwn(load, name) ? load[name] : undefined
  return shipped ? (await shipped()).default : null
}
