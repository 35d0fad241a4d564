/** What brings the rest of the core, and words: the first picture needs neither. */
export const rest = (): Promise<typeof import('forage-lab')> => import('forage-lab')

/** Loads words. Where they cannot be loaded the run goes on: texts are keys, and the next call tries again. */
export async function words(): Promise<void> {
  try {
    await (await rest()).load()
  } catch (error) {
    console.warn(error)
  }
}
