// What messages the sources make, for tests.

/** The keys of messages that source code makes. */
export const made = (source) => [...source.matchAll(/\b(?:message|label|said)!\(\s*"([^"]+)"/g)].map(([, key]) => key)

/** What is said without English: keys that have none, and texts that are empty. */
export function untold(keys, texts) {
  const without = (key) => typeof texts[key] !== 'string' || texts[key].trim() === ''
  return [...new Set([...keys, ...Object.keys(texts)])].filter(without).sort()
}
