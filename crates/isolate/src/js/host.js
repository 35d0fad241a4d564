/*
 * A planner's code, as it is called: by the number of a state. A state is plain data, so that it can be copied, hashed and gone back to;
 * random numbers, costs and geometry are lent for the time of a call. The same file hosts a planner in the module's own thread and
 * within an interpreter.
 */

import { readingsOf } from './describe.js'

/** What `lent` and `lentList` give, by number. */
const SCALAR = { random: 0, normal: 1, distance: 2, sin: 3, cos: 4, exp: 5, log: 6, pow: 7, atan2: 8, acos: 9, asin: 10, log10: 11 }
const LIST = { evaluate: 0, length: 1, isFree: 2, tour: 3 }
/** How a solution is handed over. */
const POSITION = 0
const PATH = 1
const ORDER = 2

/** What has no choice: its bits are the same in every engine. */
const EXACT = [
  ...['sqrt', 'abs', 'floor', 'ceil', 'round', 'trunc', 'sign', 'min', 'max', 'imul', 'clz32', 'fround'],
  ...['PI', 'E', 'SQRT2', 'SQRT1_2', 'LN2', 'LN10', 'LOG2E', 'LOG10E'],
]

/** Functions whose bits are the same everywhere, which those of `Math` are not. */
export function mathBy(lent) {
  const one = (name) => (x) => lent(SCALAR[name], +x, 0)
  const two = (name) => (x, y) => lent(SCALAR[name], +x, +y)
  const own = Object.fromEntries(['sin', 'cos', 'exp', 'log', 'acos', 'asin', 'log10'].map((name) => [name, one(name)]))
  const pow = two('pow')
  const exact = Object.fromEntries(EXACT.map((name) => [name, Math[name]]))
  return Object.freeze({
    ...own,
    ...exact,
    // As the language has it, unlike other powers.
    pow: (x, y) => (y !== y || ((x === 1 || x === -1) && (y === Infinity || y === -Infinity)) ? NaN : pow(x, y)),
    atan2: two('atan2'),
    tan: (x) => own.sin(x) / own.cos(x),
    hypot: (...values) => exact.sqrt(values.reduce((sum, x) => sum + x * x, 0)),
  })
}

const NUMBERS = [Float64Array, Float32Array, Int32Array, Uint32Array, Int16Array, Uint16Array, Int8Array, Uint8Array]
const isNumbers = (value) => NUMBERS.some((kind) => value instanceof kind)

const nameOf = (value) =>
  value === undefined ? 'undefined' : value === null ? 'null' : Array.isArray(value) ? 'a list' : typeof value === 'object' ? 'an object' : `a ${typeof value}`

function numbersOf(what, list) {
  if (!Array.isArray(list) && !isNumbers(list)) throw new TypeError(`${what} takes a list of numbers, not ${nameOf(list)}`)
  const numbers = Float64Array.from(list)
  for (let k = 0; k < numbers.length; k += 1)
    if (numbers[k] !== numbers[k])
      throw new TypeError(`${what}: number ${k} is not a number (NaN): was it computed from something that has no value?`)
  return numbers
}

function pointsOf(what, points) {
  if (!Array.isArray(points)) throw new TypeError(`${what} takes a list of points [x, y], not ${nameOf(points)}`)
  const out = new Float64Array(2 * points.length)
  for (const [k, point] of points.entries()) {
    if (point?.length !== 2) throw new TypeError(`${what}: point ${k} is no [x, y]`)
    out[2 * k] = point[0]
    out[2 * k + 1] = point[1]
    if (Number.isNaN(out[2 * k] + out[2 * k + 1])) throw new TypeError(`${what}: point ${k} is not a number (NaN)`)
  }
  return out
}

const frozen = (value) => {
  if (typeof value === 'object' && value !== null) for (const part of Object.values(Object.freeze(value))) frozen(part)
  return value
}

/** Where x and y of a plane's points are. */
function planeOf({ kind, bounds, rows, cell }) {
  if (kind === 'discs') return { low: bounds.min, high: bounds.max }
  return kind === 'grid' ? { low: [0, 0], high: [rows[0].length * cell, rows.length * cell] } : undefined
}

/** What an author's functions are given, besides the state. */
function toolsOf({ lent, lentList }, { scene, params, seed, low, high }, finish) {
  const evaluators = {
    function: (x) => lentList(LIST.evaluate, numbersOf('evaluate', x)),
    tour: (order) => lentList(LIST.tour, numbersOf('evaluate', order)),
  }
  const box = low ? { low, high } : planeOf(scene)
  return Object.freeze({
    scene: frozen(scene),
    params: frozen(params),
    seed,
    ...(box && { box: frozen({ low: Array.from(box.low), high: Array.from(box.high) }) }),
    math: mathBy(lent),
    random: () => lent(SCALAR.random, 0, 0),
    normal: () => lent(SCALAR.normal, 0, 0),
    evaluate: evaluators[scene.kind] ?? ((path) => lentList(LIST.length, pointsOf('evaluate', path))),
    isFree: (a, b) => lentList(LIST.isFree, pointsOf('isFree', [a, b])) === 1,
    distance: (from, to) => lent(SCALAR.distance, from, to),
    finish,
  })
}

const DEEPEST = 64
const RULE = 'a state is made of numbers, texts, true, false, null, lists, typed arrays and plain objects'

/** Refuses what is no plain data. `depth` ends a state that holds itself. */
function mustBePlain(value, at, depth) {
  if (value === null || typeof value !== 'object') {
    if (typeof value === 'function' || typeof value === 'symbol' || typeof value === 'bigint')
      throw new TypeError(`${at} is a ${typeof value}: ${RULE}`)
    return
  }
  if (isNumbers(value)) return
  if (depth > DEEPEST) throw new TypeError(`${at} is nested deeper than ${DEEPEST} levels, or holds itself: ${RULE}`)
  if (Array.isArray(value)) {
    for (let k = 0; k < value.length; k += 1) if (typeof value[k] !== 'number') mustBePlain(value[k], `${at}[${k}]`, depth + 1)
    return
  }
  const prototype = Object.getPrototypeOf(value)
  if (prototype !== Object.prototype && prototype !== null)
    throw new TypeError(`${at} is a ${value.constructor?.name ?? 'strange object'}: ${RULE}`)
  for (const key of Object.keys(value)) mustBePlain(value[key], `${at}.${key}`, depth + 1)
}

/** A copy. What is in two places is one thing in the copy, too: code may change it in place. */
function copied(value, seen = new Map()) {
  if (typeof value !== 'object' || value === null) return value
  const known = seen.get(value)
  if (known) return known
  if (isNumbers(value)) {
    const copy = value.slice()
    seen.set(value, copy)
    return copy
  }
  const copy = Array.isArray(value) ? new Array(value.length) : {}
  seen.set(value, copy)
  for (const key of Object.keys(value)) copy[key] = copied(value[key], seen)
  return copy
}

const halves = new Uint32Array(2)
const whole = new Float64Array(halves.buffer)

/** A number of 64 bits for a state, in two halves: equal states have equal ones. */
function digestOf(value) {
  let a = 0x9e3779b9
  let b = 0x85ebca6b
  const word = (next) => {
    a = Math.imul(a ^ next, 0x01000193)
    a ^= a >>> 15
    b = Math.imul(b ^ a, 0xc2b2ae35)
    b ^= b >>> 13
  }
  const number = (next) => {
    // One NaN for all.
    whole[0] = Number.isNaN(next) ? Number.NaN : next
    word(halves[0])
    word(halves[1])
  }
  const text = (next) => {
    word(next.length)
    for (let k = 0; k < next.length; k += 1) word(next.charCodeAt(k))
  }
  const add = (next) => {
    if (typeof next === 'number') {
      word(1)
      number(next)
    } else if (typeof next === 'string') {
      word(2)
      text(next)
    } else if (typeof next === 'boolean') word(next ? 3 : 4)
    else if (next === null || next === undefined) word(next === null ? 5 : 6)
    else if (isNumbers(next)) {
      word(7)
      word(next.length)
      for (const part of next) number(part)
    } else if (Array.isArray(next)) {
      word(8)
      word(next.length)
      for (const part of next) add(part)
    } else {
      word(9)
      const keys = Object.keys(next).sort()
      word(keys.length)
      for (const key of keys) {
        text(key)
        add(next[key])
      }
    }
  }
  add(value)
  return Uint32Array.of(a, b)
}

function sizeOf(value) {
  if (typeof value === 'string') return 16 + 2 * value.length
  if (typeof value !== 'object' || value === null) return 8
  if (isNumbers(value)) return 64 + value.byteLength
  let size = 32
  for (const key of Object.keys(value)) size += 16 + sizeOf(value[key])
  return size
}

const SHAPES = { points: 'points', line: 'polyline', segments: 'segments' }

/** What is drawn by, and what was drawn. */
function penOf(layers) {
  const pieces = []
  const put = (name, shape) => (role, points, weights) => {
    const layer = layers.indexOf(role)
    if (layer < 0) throw new RangeError(`draw: there is no layer "${role}"; known: ${layers.join(', ')}`)
    if (!Array.isArray(points)) throw new TypeError(`draw: ${name}(layer, points) takes a list of points, not ${nameOf(points)}`)
    const vertices = new Float64Array(3 * points.length)
    for (const [k, point] of points.entries()) vertices.set([point[0], point[1] ?? 0, weights?.[k] ?? 0], 3 * k)
    pieces.push([layer, shape, vertices])
  }
  return { pen: Object.fromEntries(Object.entries(SHAPES).map(([name, shape]) => [name, put(name, shape)])), pieces }
}

/** A solution by its cost, what it is, and its numbers; null: there is none yet. */
function handedOver(found) {
  if (found === null || found === undefined) return null
  const { cost, position, path, order } = found
  const numeric = typeof cost === 'number' ? cost : Number.NaN
  if (path) return [numeric, PATH, pointsOf('best: path', path)]
  if (order) return [numeric, ORDER, numbersOf('best: order', order)]
  return [numeric, POSITION, numbersOf('best: position', position)]
}

const textOf = (value) => (value === undefined || value === null ? '' : String(value))

/**
 * The functions that the core calls.
 * @param planner what the author wrote
 * @param layers the names of its layers
 * @param lend what is lent: `lent` and `lentList`
 */
export function hostOf(planner, layers, lend) {
  const states = new Map()
  const measured = readingsOf(planner)
  let next = 1
  let finished = false
  const finish = () => {
    finished = true
  }
  const keep = (state, tools) => {
    const id = next
    next += 1
    states.set(id, { state, tools })
    return id
  }
  const keptOf = (id) => {
    const kept = states.get(id)
    // Where a copy failed, there is none.
    if (!kept) throw new Error('its states could not be kept: together they need more than 64 MB')
    return kept
  }
  const plain = (state) => {
    if (typeof state !== 'object' || state === null) throw new TypeError(`the state is ${nameOf(state)}: it must be an object`)
    mustBePlain(state, 'state', 0)
    return state
  }
  return {
    /** What is kept of a state, for those who look into it. */
    state: (id) => keptOf(id).state,
    start(scene, params, seed, low, high) {
      const tools = toolsOf(lend, { scene, params, seed, low, high }, finish)
      return keep(plain(planner.start(tools)), tools)
    },
    advance(id) {
      const kept = keptOf(id)
      finished = false
      const after = planner.advance(kept.state, kept.tools)
      // Code may change the state in place.
      if (after !== undefined) kept.state = after
      plain(kept.state)
      return finished ? -id : id
    },
    best: (id) => handedOver(planner.best(keptOf(id).state)),
    readings(id) {
      const { state } = keptOf(id)
      return Float64Array.from(measured, ({ value }) => Number(value(state)))
    },
    draw(id) {
      const { state, tools } = keptOf(id)
      const { pen, pieces } = penOf(layers)
      if (planner.draw) planner.draw(state, pen, tools)
      else {
        const best = planner.best(state)
        const stops = tools.scene.stops ?? tools.scene.points
        if (best?.path) pen.line(layers[0], Array.from(best.path))
        else if (best?.position) pen.points(layers[0], [Array.from(best.position)])
        else if (best?.order && stops)
          pen.line(
            layers[0],
            Array.from(best.order, (stop) => stops[stop]),
          )
      }
      return pieces
    },
    explain(id, layer, index) {
      const { state, tools } = keptOf(id)
      const said = planner.explain?.(state, { layer, index }, tools)
      if (said === undefined || said === null) return null
      const { title, summary, values } = typeof said === 'object' ? said : { summary: said }
      const numbers = Object.entries(values ?? {}).filter(([, value]) => typeof value === 'number')
      const named = textOf(planner.layers?.find(({ name }) => name === layer)?.title) || layer
      return [textOf(title) || `${named} ${index + 1}`, textOf(summary), numbers]
    },
    copy(id) {
      const { state, tools } = keptOf(id)
      return keep(copied(state), tools)
    },
    forget: (id) => void states.delete(id),
    digest: (id) => digestOf(keptOf(id).state),
    size: (id) => sizeOf(keptOf(id).state),
  }
}
