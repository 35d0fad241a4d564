/* What a planner prints, as a text. */

const MOST = 50
const DEEPEST = 3

const list = (items, show) => `${items.slice(0, MOST).map(show).join(', ')}${items.length > MOST ? ', …' : ''}`

function inside(value, depth) {
  const show = (item) => textOf(item, depth + 1)
  const pairs = (entries) => list(entries, ([key, item]) => `${key}: ${show(item)}`)
  if (value instanceof Error) return `${value.name}: ${value.message}`
  if (Array.isArray(value)) return `[${list(value, show)}]`
  if (ArrayBuffer.isView(value)) return `${value.constructor.name} [${list(Array.from(value), show)}]`
  if (value instanceof Map) return `Map { ${pairs(Array.from(value, ([key, item]) => [show(key), item]))} }`
  if (value instanceof Set) return `Set { ${list(Array.from(value), show)} }`
  return `{ ${pairs(Object.entries(value))} }`
}

function textOf(value, depth) {
  if (typeof value === 'string') return depth === 0 ? value : JSON.stringify(value)
  if (typeof value === 'function') return 'a function'
  if (typeof value === 'bigint') return `${value}n`
  if (typeof value !== 'object' || value === null) return Object.is(value, -0) ? '-0' : String(value)
  return depth > DEEPEST ? '…' : inside(value, depth)
}

/** A value in words: NaN and infinities are written as they are, unlike in JSON. */
export function shown(value) {
  try {
    return textOf(value, 0)
  } catch {
    return 'something that cannot be shown'
  }
}
