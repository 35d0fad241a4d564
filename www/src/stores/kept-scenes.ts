import type { DBSchema, IDBPDatabase } from 'idb'

/* Scenes and lessons that are too large for an address, in this browser. */

/** So many are kept; the oldest make room. */
const MOST = 24

interface Schema extends DBSchema {
  scenes: { key: string; value: { text: string; at: number }; indexes: { at: number } }
}

async function database(): Promise<IDBPDatabase<Schema>> {
  const { openDB } = await import('idb')
  return openDB<Schema>('forage-scenes', 1, { upgrade: (opened) => void opened.createObjectStore('scenes').createIndex('at', 'at') })
}

const kept = new Set<string>()
/** Keeps a text under a name. */
export async function keep(name: string, text: string): Promise<void> {
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

/** The text of this name, if it is there. */
export const find = async (name: string): Promise<string | undefined> => (await (await database()).get('scenes', name))?.text
