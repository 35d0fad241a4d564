/* A scene that is too large for an address stays in this browser; the address has a name for it instead. */

/** Many programs cut off longer links. */
export const LARGEST = 8192
const SCENE = /([#&]scene=)(~[^&]*)/
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

/** A link or address as it is shown: a large scene is kept apart, where a browser can. */
export function shortened(link: string): string {
  const [, , text] = SCENE.exec(link) ?? []
  if (unable || link.length <= LARGEST || text === undefined) return link
  const name = nameOf(text)
  import('./kept-scenes')
    .then(({ keep }) => keep(name, text))
    .catch(() => {
      unable = true
    })
  return link.replace(SCENE, `$1@${name}`)
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
