/** A number or a text of a state: where it is, as one would write it, and what it was and is. */
export interface Variable {
  path: string
  /** Undefined: there was none, or there is none any more. */
  before: string | undefined
  now: string | undefined
}

type Leaf = number | string | boolean | null

/** So many digits tell numbers apart that differ. */
const DIGITS = 6

const isLeaf = (value: unknown): value is Leaf => value === null || typeof value !== 'object'

const brief = (value: Leaf): string => (typeof value === 'number' ? String(Number(value.toPrecision(DIGITS))) : JSON.stringify(value))

/** All numbers and texts in plain data, by where they are. */
function leavesOf(value: unknown, path: string, found: Map<string, Leaf>): Map<string, Leaf> {
  if (value === undefined) return found
  if (isLeaf(value)) return found.set(path, value)
  const isList = Array.isArray(value)
  for (const [key, item] of Object.entries(value as object))
    leavesOf(item, isList ? `${path}[${key}]` : path === '' ? key : `${path}.${key}`, found)
  return found
}

/** What differs between two states. Texts of numbers that differ in later digits than are shown have all of them. */
export function changes(before: unknown, now: unknown): { changed: Variable[]; same: number } {
  const old = leavesOf(before, '', new Map())
  const present = leavesOf(now, '', new Map())
  const changed: Variable[] = []
  let same = 0
  for (const [path, value] of present) {
    const was = old.get(path)
    if (old.has(path) && Object.is(was, value)) {
      same += 1
      continue
    }
    const texts = [was, value].map((one) => (one === undefined ? undefined : brief(one)))
    const [a, b] = texts[0] === texts[1] ? [String(was), String(value)] : texts
    changed.push({ path, before: a, now: b })
  }
  for (const [path, value] of old) if (!present.has(path)) changed.push({ path, before: brief(value), now: undefined })
  return { changed, same }
}
