/*
 * The inside of the interpreter: this script runs there before an author's code. What is outside is reached by `lent` and `lentList`
 * alone, and gives numbers; what goes out are numbers, texts and buffers.
 */
import { describe } from './describe.js'
import { hostOf, mathBy } from './host.js'
import { powerBy, withPowers } from './powers.js'
import { shown } from './shown.js'

const { lent, list, print } = globalThis.outside
delete globalThis.outside
const { parse, stringify } = JSON
const listOf = Array.from

/** An outside call with a list of numbers. */
const lentList = (what, numbers) => list(what, numbers.buffer)

// Mathematics that may differ between engines is the core's. Chance and time are none of it.
const mathematics = mathBy(lent)
for (const name of Object.getOwnPropertyNames(Math)) if (!(name in mathematics)) delete Math[name]
for (const [name, value] of Object.entries(mathematics)) if (typeof value === 'function') Math[name] = value
Math.random = () => {
  throw new Error('Math.random is another one each time: take `random` from what `start` and `advance` are given')
}
Object.defineProperty(globalThis, 'power$', { value: powerBy(mathematics.pow) })

// The clock looks between instructions, not within what is built in: that takes no lists and texts for which it would need seconds.
const { apply } = Reflect
const guard = (prototype, names, isTooMuch, allowed) => {
  for (const name of names) {
    const method = prototype[name]
    if (method === undefined) continue
    const guarded = {
      [name](...given) {
        if (isTooMuch(this, given[0])) throw new RangeError(`${name}: there is too much to go through; it takes ${allowed}`)
        return apply(method, this, given)
      },
    }
    Object.defineProperty(prototype, name, { value: guarded[name] })
  }
}
const LISTS =
  'indexOf lastIndexOf includes fill copyWithin reverse join toString toLocaleString slice splice concat unshift shift flat flatMap sort toSorted toReversed toSpliced with map filter forEach some every reduce reduceRight'
const ITEMS = 'at most 10 million items'
guard(Array.prototype, LISTS.split(' '), (list) => list?.length > 1e7, ITEMS)
guard(String, ['raw'], (_, { raw }) => raw?.length > 1e7, ITEMS)
const isLong = (text, sought) => typeof sought === 'string' && sought.length * String(text).length > 1e9
guard(String.prototype, 'indexOf lastIndexOf includes split replace replaceAll'.split(' '), isLong, 'texts whose lengths multiply to at most 10⁹')

const log = (...values) => print(values.map(shown).join(' ').slice(0, 1000))
delete globalThis.SharedArrayBuffer
delete globalThis.Atomics
globalThis.console = { log, info: log, warn: log, error: log, debug: log }

const given = []
globalThis.register = async (planner) => {
  given.push(planner)
}

let planner
let host

/** Plain data of a state, as text; typed arrays as lists. */
const plainOf = (state) =>
  stringify(state, (_, value) =>
    ArrayBuffer.isView(value) ? listOf(value) : typeof value === 'number' && !Number.isFinite(value) ? String(value) : value,
  )

/** What the outside calls, by name. */
globalThis.inside = {
  /** A code as it is run. */
  portable: withPowers,
  /** What the planner says of itself, or why it is refused. */
  described() {
    if (given.length !== 1)
      return stringify({
        code: 'refused',
        field: 'code',
        message: `the code must call \`register({ … })\` once; it does so ${given.length} times`,
      })
    try {
      planner = given[0]
      const described = describe(planner)
      host = hostOf(
        planner,
        described.layers.map(({ role }) => role),
        { lent, lentList },
      )
      return stringify(described)
    } catch ({ field, value, allowed, message }) {
      return stringify({ code: 'refused', field, value, allowed, message })
    }
  },
  /** What the author wrote, without the code: looked at once more outside, for the code may have changed what looks at it here. */
  written: () => stringify(planner, (_, value) => (typeof value === 'function' ? 'code' : value)),
  start: (scene, params, seed, low, high) =>
    host.start(parse(scene), parse(params), seed, low && new Float64Array(low), high && new Float64Array(high)),
  advance: (id) => host.advance(id),
  best(id) {
    const found = host.best(id)
    if (found === null) return null
    const [cost, kind, numbers] = found
    const out = new Float64Array(2 + numbers.length)
    out.set([cost, kind])
    out.set(numbers, 2)
    return out.buffer
  },
  readings: (id) => host.readings(id).buffer,
  /** Each piece: its layer, its shape, how many numbers, and those. */
  draw(id) {
    const shapes = ['points', 'polyline', 'segments']
    const pieces = host.draw(id)
    const out = new Float64Array(pieces.reduce((sum, [, , vertices]) => sum + 3 + vertices.length, 0))
    let at = 0
    for (const [layer, shape, vertices] of pieces) {
      out.set([layer, shapes.indexOf(shape), vertices.length], at)
      out.set(vertices, at + 3)
      at += 3 + vertices.length
    }
    return out.buffer
  },
  explain: (id, layer, index) => stringify(host.explain(id, layer, index)),
  copy: (id) => host.copy(id),
  forget: (id) => host.forget(id),
  digest: (id) => new Float64Array(host.digest(id)).buffer,
  size: (id) => host.size(id),
  state: (id) => plainOf(host.state(id)) ?? 'null',
}
