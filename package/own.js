/*
 * Planners in JavaScript. `register` takes what an author writes and makes of it what the core calls: functions of the number of a state.
 * A state is plain data, so that it can be copied, hashed and gone back to; random numbers, costs and geometry are lent by the core for
 * the time of a call.
 */
import { lent, lentList, registerPlanner } from './glue.js'
import { holdersOf } from './loader.js'

const flat = (points) => {
  const out = new Float64Array(2 * points.length)
  for (const [k, [x, y]] of points.entries()) out.set([x, y], 2 * k)
  return out
}

/** Functions whose bits are the same everywhere, which those of `Math` are not. */
const math = Object.freeze({
  sin: (x) => lent(3, x, 0),
  cos: (x) => lent(4, x, 0),
  exp: (x) => lent(5, x, 0),
  log: (x) => lent(6, x, 0),
  pow: (x, y) => lent(7, x, y),
  atan2: (y, x) => lent(8, y, x),
  acos: (x) => lent(9, x, 0),
  asin: (x) => lent(10, x, 0),
  log10: (x) => lent(11, x, 0),
  sqrt: Math.sqrt,
  abs: Math.abs,
  floor: Math.floor,
  ceil: Math.ceil,
  round: Math.round,
  min: Math.min,
  max: Math.max,
  PI: Math.PI,
})

/** What an author's functions are given, besides the state. */
function toolsOf(scene, params, seed, low, high) {
  const box = low && Object.freeze({ low: Object.freeze([...low]), high: Object.freeze([...high]) })
  const length = (path) => lentList(1, flat(path))
  const tour = (order) => lentList(3, Float64Array.from(order))
  return {
    scene,
    params,
    seed,
    box,
    math,
    random: () => lent(0, 0, 0),
    normal: () => lent(1, 0, 0),
    evaluate: box ? (x) => lentList(0, x) : scene.kind === 'tour' ? tour : length,
    isFree: (a, b) => lentList(2, flat([a, b])) === 1,
    distance: (from, to) => lent(2, from, to),
  }
}

const frozen = (value) => {
  if (typeof value === 'object' && value !== null) for (const part of Object.values(Object.freeze(value))) frozen(part)
  return value
}

const NUMBERS = [Float64Array, Float32Array, Int32Array, Uint32Array, Int16Array, Uint16Array, Int8Array, Uint8Array]
const isNumbers = (value) => NUMBERS.some((kind) => value instanceof kind)
const DEEPEST = 64

/** What is in a state that is no plain data; undefined where there is nothing. */
function unplain(value, at, depth) {
  if (value === null || ['number', 'string', 'boolean', 'undefined'].includes(typeof value) || isNumbers(value)) return undefined
  const kind = typeof value === 'object' ? Object.getPrototypeOf(value) : undefined
  if (depth > DEEPEST) return `${at}: nested deeper than ${DEEPEST} levels`
  if (Array.isArray(value) || kind === Object.prototype || kind === null) {
    for (const [key, part] of Object.entries(value)) {
      const found = unplain(part, Array.isArray(value) ? `${at}[${key}]` : `${at}.${key}`, depth + 1)
      if (found) return found
    }
    return undefined
  }
  return `${at}: ${typeof value === 'function' ? 'a function' : typeof value === 'object' ? `a ${value.constructor?.name ?? 'strange object'}` : `a ${typeof value}`}`
}

function copied(value) {
  if (typeof value !== 'object' || value === null) return value
  if (isNumbers(value)) return value.slice()
  if (Array.isArray(value)) return value.map(copied)
  const copy = {}
  for (const key of Object.keys(value)) copy[key] = copied(value[key])
  return copy
}

const halves = new Uint32Array(2)
const whole = new Float64Array(halves.buffer)

/** A number of 64 bits for a state, in two halves: equal states have equal ones. */
function digestOf(value) {
  let [a, b] = [0x9e3779b9, 0x85ebca6b]
  const word = (next) => {
    a = Math.imul(a ^ next, 0x01000193)
    a ^= a >>> 15
    b = Math.imul(b ^ a, 0xc2b2ae35)
    b ^= b >>> 13
  }
  const number = (next) => {
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
  return Object.values(value).reduce((sum, part) => sum + sizeOf(part), 32 + 16 * Object.keys(value).length)
}

const SHAPES = { points: 'points', line: 'polyline', segments: 'segments' }

/** What is drawn by, and what was drawn. */
function penOf(layers) {
  const pieces = []
  const put = (shape) => (name, points, weights) => {
    const layer = layers.indexOf(name)
    if (layer < 0) throw new RangeError(`draw: there is no layer "${name}"; known: ${layers.join(', ')}`)
    const vertices = new Float64Array(3 * points.length)
    for (const [k, point] of points.entries()) vertices.set([point[0], point[1] ?? 0, weights?.[k] ?? 0], 3 * k)
    pieces.push([layer, shape, vertices])
  }
  const pen = Object.fromEntries(Object.entries(SHAPES).map(([name, shape]) => [name, put(shape)]))
  return { pen, pieces }
}

const FUNCTIONS = { start: true, advance: true, best: true, draw: false, explain: false }

/** The functions that the core calls. */
function hostOf(planner, layers) {
  const states = new Map()
  let next = 1
  let finished = false
  const keep = (state, tools) => {
    const id = next
    next += 1
    states.set(id, { state, tools })
    return id
  }
  const plain = (state) => {
    if (typeof state !== 'object' || state === null) throw new TypeError('the state must be an object of plain data')
    const wrong = unplain(state, 'state', 0)
    if (wrong) throw new TypeError(`${wrong} is no plain data: a state is made of numbers, texts, lists, typed arrays and plain objects`)
    return state
  }
  const finish = () => {
    finished = true
  }
  const solution = (found) => {
    if (found === null || found === undefined) return null
    const { cost, position, path, order } = found
    const listed = (list) => list && Array.from(list)
    return {
      cost,
      ...(path && { path: Array.from(path, ([x, y]) => [x, y]) }),
      ...(order && { order: listed(order) }),
      ...(!path && !order && { position: listed(position) }),
    }
  }
  return {
    start(scene, params, seed, low, high) {
      const tools = Object.freeze({ ...toolsOf(frozen(scene), frozen(params), seed, low, high), finish })
      return keep(plain(planner.start(tools)), tools)
    },
    advance(id) {
      const kept = states.get(id)
      finished = false
      const after = planner.advance(kept.state, kept.tools)
      if (after !== undefined) kept.state = after
      plain(kept.state)
      return finished ? -id : id
    },
    best: (id) => solution(planner.best(states.get(id).state)),
    readings(id) {
      const { state } = states.get(id)
      return Float64Array.from(planner.readings ?? [], ({ value }) => Number(value(state)))
    },
    draw(id) {
      const { state, tools } = states.get(id)
      const { pen, pieces } = penOf(layers)
      if (planner.draw) planner.draw(state, pen, tools)
      else {
        const best = solution(planner.best(state))
        if (best?.path) pen.line('best', best.path)
        else if (best?.position) pen.points('best', [best.position])
      }
      return pieces
    },
    explain: (id, layer, index) => planner.explain?.(states.get(id).state, { layer, index }, states.get(id).tools) ?? null,
    copy(id) {
      const { state, tools } = states.get(id)
      return keep(copied(state), tools)
    },
    forget: (id) => void states.delete(id),
    digest: (id) => digestOf(states.get(id).state),
    size: (id) => sizeOf(states.get(id).state),
  }
}

/** What an author writes, as the core reads it. */
function described(planner) {
  for (const [name, needed] of Object.entries(FUNCTIONS)) {
    const found = planner[name]
    if (typeof found === 'function' || (!needed && found === undefined)) continue
    throw Object.assign(new TypeError(`planner.${name} must be a function`), { field: name, code: 'refused' })
  }
  const { name, title, summary, kinds, parameters = [], readings = [], layers = [] } = planner
  if (holdersOf('planner', name))
    throw Object.assign(new RangeError(`name: "${name}" is a planner that ships; take another name`), {
      field: 'name',
      value: name,
      code: 'refused',
    })
  for (const [k, reading] of Array.from(readings).entries()) {
    if (typeof reading?.value !== 'function')
      throw Object.assign(new TypeError(`readings[${k}].value must be a function of the state`), {
        field: `readings[${k}].value`,
        code: 'refused',
      })
  }
  return {
    name,
    ...(title !== undefined && { title }),
    ...(summary !== undefined && { summary }),
    kinds,
    parameters,
    readings: Array.from(readings, ({ value: _value, ...reading }) => reading),
    layers: layers.length > 0 || planner.draw ? layers : [{ name: 'best' }],
  }
}

/** Adds a planner to those that are known; `load` loads the part of the module that runs them. */
export const registrar = (load) => async (planner) => {
  await load('code')
  const description = described(planner)
  registerPlanner(
    description,
    hostOf(
      planner,
      description.layers.map(({ name }) => name),
    ),
  )
}
