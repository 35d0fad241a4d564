import type { Language } from 'forage-lab'

/** What brings the rest of the core, and words: the first picture needs neither. */
export const rest = (): Promise<typeof import('forage-lab')> => import('forage-lab')

let language = 'en'

/** Has the core speak this language; its words are loaded if some were before. */
export async function speakIn(tag: string): Promise<void> {
  if (tag === language) return
  try {
    await (await rest()).speakIn(tag as Language)
    language = tag
  } catch (error) {
    console.warn(error)
  }
}

/** Loads words. Where they cannot be loaded the run goes on: texts are keys, and the next call tries again. */
export async function words(): Promise<void> {
  try {
    await (await rest()).load()
  } catch (error) {
    console.warn(error)
  }
}
