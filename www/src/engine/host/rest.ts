import type { Language } from 'forage-lab'

/** What brings the rest of the core, and words: the first picture needs neither. */
export const rest = (): Promise<typeof import('forage-lab')> => import('forage-lab')

/** The language that was wanted last, and when it is spoken. */
let wanted = { tag: 'en', spoken: Promise.resolve() }

/** Has the core speak this language; its words are loaded if some were before. A later call wins. */
export function speakIn(tag: string): Promise<void> {
  if (tag !== wanted.tag) wanted = { tag, spoken: speak(tag) }
  return wanted.spoken
}

async function speak(tag: string): Promise<void> {
  try {
    await (await rest()).speakIn(tag as Language)
  } catch (error) {
    // The next call tries again.
    if (wanted.tag === tag) wanted = { tag: '', spoken: Promise.resolve() }
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
