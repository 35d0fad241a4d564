/* Scenes that are too large for an address stay in this browser; the address has a name for each instead. */

/** Many programs cut off longer links. */
export const LARGEST = 8192
/** That of the run, and those that single planners have in Compare. */
const SCENES = /([#&]scene=|;@=)(~[^&;,]*)/g
const APART = /([#&]scene=)@([0-9a-f]{16})/

/** A name for a text (FNV-1a, twice 32 bits). */
export function nameOf(text: string): string {
  let [low, high] = [0x811c9dc5, 0x01234567]
  for (let at = 0; at < text.length; at += 1) {
    const letter = text.charCodeAt(at)
    low = Math.imul(low ^ letter, 0x01000193)
    high = Math.imul(high ^ letter ^ (low >>> 13), 0x01000193)
  }
  return [high, low].map((half) => (half >>> 0).toString(16).padStart(8, '0')).join('')
}

/** This browser keeps nothing: addresses are as long as they are. */
let unable = false

/** A link or address as it is shown: where it is too long its scenes are kept apart, where a browser can. */
export function shortened(link: string): string {
  if (unable || link.length <= LARGEST) return link
  const texts = new Map<string, string>()
  const short = link.replace(SCENES, (_, key: string, text: string) => {
    const name = nameOf(text)
    texts.set(name, text)
    return `${key}@${name}`
  })
  import('./kept-scenes')
    .then(({ keep }) => Promise.all([...texts].map(([name, text]) => keep(name, text))))
    .catch(() => {
      unable = true
    })
  return short
}

/** Whether its scene is kept apart. */
export const isShortened = (link: string): boolean => APART.test(link)

/** The same with its scene; as it is where this browser has none by that name. */
export async function restored(link: string): Promise<string> {
  const [, , name] = APART.exec(link) ?? []
  if (name === undefined) return link
  try {
    const { find } = await import('./kept-scenes')
    const text = await find(name)
    return text === undefined ? link : link.replace(APART, (_, key: string) => key + text)
  } catch {
    return link
  }
}
