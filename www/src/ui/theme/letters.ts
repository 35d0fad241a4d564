import address from '@fontsource-variable/inter/files/inter-latin-wght-normal.woff2?url'

/**
 * Fetches the letters that the page is set in, and those of its titles; until they are there, and where they can't come, it is set in the system's.
 * `elsewhere`: gives their address to those who draw away from the page, and waits until they have them.
 */
export async function letters(elsewhere: (address: string) => Promise<void>): Promise<void> {
  const { documentElement: root, fonts } = document
  try {
    const own = await new FontFace('Inter', `url("${address}")`, { weight: '100 900' }).load()
    await elsewhere(new URL(address, location.href).href)
    await import('./literata.css')
    await fonts.load('1em Literata')
    fonts.add(own)
    root.dataset.letters = 'own'
  } catch {
    root.dataset.letters = 'system'
  }
}
