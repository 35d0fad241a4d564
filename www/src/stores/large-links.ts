import type { DBSchema, IDBPDatabase } from 'idb'

/* A scene that is too large for an address stays in this browser; the address has a name for it instead. */

/** Many programs cut off longer links. */
export const LARGEST = 8192
const SCENE = /([#&]scene=)(~[^&]*)/
const APART = /([#&]scene=)@([0-9a-f]{16})/
/** So many scenes are kept; the oldest make room. */
const MOST = 24

interface Schema extends DBSchema {
  scenes: { key: string; value: { text: string; at: number }; indexes: { at: number } }
}

async function database(): Promise<IDBPDatabase<Schema>> {
  const { openDB } = await import('idb')
  return openDB<Schema>('forage-scenes', 1, { upgrade: (opened) => void opened.createObjectStore('scenes').createIndex('at', 'at') })
}

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

const kept = new Set<string>()
/** This browser keeps nothing: addresses are as long as they are. */
let unable = false

async function keep(name: string, text: string): Promise<void> {
  if (kept.has(name)) return
  kept.add(name)
  const { store, done } = (await database()).transaction('scenes', 'readwrite')
  await store.put({ text, at: Date.now() }, name)
  const names = await store.index('at').getAllKeys()
  for (const old of names.slice(0, Math.max(0, names.length - MOST))) {
    kept.delete(old)
    await store.delete(old)
  }
  await done
}

/** A link or address as it is shown: a large scene is kept apart, where a browser can. */
export function shortened(link: string): string {
  const [, , text] = SCENE.exec(link) ?? []
  if (unable || link.length <= LARGEST || text === undefined) return link
  const name = nameOf(text)
  keep(name, text).catch(() => {
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
    const found = await (await database()).get('scenes', name)
    return found ? link.replace(APART, (_, key: string) => key + found.text) : link
  } catch {
    return link
  }
}
