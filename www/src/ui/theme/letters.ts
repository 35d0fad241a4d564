import address from '@fontsource-variable/inter/files/inter-latin-wght-normal.woff2?url'

/** Fetches the letters that the page is set in; until they are there, and where they can't come, it is set in the system's. */
export async function letters(): Promise<void> {
  const { documentElement: root, fonts } = document
  try {
    fonts.add(await new FontFace('Inter', `url("${address}")`, { weight: '100 900' }).load())
    root.dataset.letters = 'own'
  } catch {
    root.dataset.letters = 'system'
  }
}
