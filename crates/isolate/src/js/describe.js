/*
 * What an author says of a planner, checked and written as the catalogue lists planners. An error names the field, its value and what
 * is allowed, as the module's own errors do.
 */

/** Scenes that such planners may run on. */
const KINDS = ['function', 'discs', 'grid', 'tour']
/** Those of which each candidate is a result. */
const ALWAYS = ['function', 'tour']
const FIELDS = [
  'name',
  'title',
  'summary',
  'kinds',
  'parameters',
  'readings',
  'layers',
  'formulas',
  'start',
  'advance',
  'best',
  'draw',
  'explain',
]
const NAME = /^[a-z][a-z0-9_-]*$/
const LONGEST_NAME = 60
/** Of a title or a help text. */
const LONGEST = 2000
const MOST = 100
const WHOLE = 1e15

function shown(value) {
  if (value === undefined || value === null) return 'nothing'
  if (typeof value === 'string') return JSON.stringify(value.length > 60 ? `${value.slice(0, 60)}…` : value)
  if (typeof value === 'number' || typeof value === 'boolean') return String(value)
  if (Array.isArray(value)) return `a list of ${value.length}`
  return typeof value === 'function' ? 'a function' : 'an object'
}

/** The error for a field whose value is not allowed. */
export function refused(field, value, allowed) {
  const error = new RangeError(`${field}: ${shown(value)} is not allowed; it must be ${allowed}`)
  return Object.assign(error, { code: 'refused', field, value: shown(value), allowed })
}

const isObject = (value) => typeof value === 'object' && value !== null && !Array.isArray(value)

/** Reads an object's fields one by one; those that were not read are refused at the end. */
function reader(at, value, known) {
  if (!isObject(value)) throw refused(at, value, 'an object with a name')
  const path = (name) => (at === '' || at === 'planner' ? name : `${at}.${name}`)
  for (const name of Object.keys(value))
    if (!known.includes(name)) throw refused(path(name), value[name], `left out; known here: ${known.join(', ')}`)
  const text = (name, otherwise) => {
    const found = value[name]
    if (found === undefined && otherwise !== undefined) return otherwise
    if (typeof found !== 'string' || found.length > LONGEST) throw refused(path(name), found, `a text of at most ${LONGEST} characters`)
    return found
  }
  return {
    path,
    text,
    name() {
      const found = value.name
      if (typeof found !== 'string' || found.length > LONGEST_NAME || !NAME.test(found))
        throw refused(path('name'), found, '1 to 60 small letters, digits, - and _, a letter first')
      return found
    },
    number(name, otherwise) {
      const found = value[name] ?? otherwise
      if (!Number.isFinite(found)) throw refused(path(name), value[name], 'a finite number')
      return found
    },
    flag(name, otherwise = false) {
      const found = value[name] ?? otherwise
      if (typeof found !== 'boolean') throw refused(path(name), found, 'true or false')
      return found
    },
    code(name, needed) {
      const found = value[name]
      if (typeof found !== 'function' && (needed || found !== undefined)) throw refused(path(name), found, 'a function')
      return found
    },
    list(name, read) {
      const found = value[name] ?? []
      if (!Array.isArray(found) || found.length > MOST) throw refused(path(name), found, `a list of at most ${MOST}`)
      return found.map((item, k) => read(`${path(name)}[${k}]`, item))
    },
  }
}

function parameter(at, value) {
  const fields = reader(at, value, ['name', 'title', 'symbol', 'help', 'default', 'min', 'max', 'integer', 'options'])
  const name = fields.name()
  const about = { name, symbol: fields.text('symbol', ''), title: fields.text('title', name), help: fields.text('help', '') }
  const given = value.default
  const path = fields.path('default')
  if (typeof given === 'boolean') return { ...about, default: given, type: 'flag' }
  const options = fields.list('options', (place, option) => {
    if (typeof option !== 'string' || option === '' || option.length > 60) throw refused(place, option, 'a text of 1 to 60 characters')
    return { value: option, title: option, help: '' }
  })
  if (options.length > 0) {
    const names = options.map((option) => option.value)
    if (new Set(names).size < names.length) throw refused(fields.path('options'), value.options, 'a list of texts, each of them once')
    if (!names.includes(given)) throw refused(path, given, `one of ${names.join(', ')}`)
    return { ...about, default: given, type: 'choice', options }
  }
  const integer = fields.flag('integer')
  const [min, max] = [fields.number('min', integer ? 0 : -1e9), fields.number('max', 1e9)]
  if (min > max) throw refused(fields.path('max'), max, `at least min = ${min}`)
  const isWhole = (number) => Number.isInteger(number) && number >= 0 && number <= WHOLE
  if (integer)
    for (const [end, bound] of Object.entries({ min, max }))
      if (!isWhole(bound)) throw refused(fields.path(end), bound, 'a whole number from 0, where integer is true')
  if (!Number.isFinite(given) || given < min || given > max || (integer && !isWhole(given)))
    throw refused(path, given, `a ${integer ? 'whole ' : ''}number from ${min} to ${max}`)
  if (!integer) return { ...about, default: given, type: 'number', min, max }
  return {
    ...about,
    default: given,
    type: 'integer',
    min,
    max,
    step: 1,
    soft_min: min,
    soft_max: max,
    logarithmic: min > 0 && max / min > 1000,
  }
}

const ITERATIONS = {
  name: 'iterations',
  symbol: 'k_{\\max}',
  title: 'Iterations',
  help: 'After how many iterations it stops.',
  default: 1000,
  type: 'integer',
  min: 1,
  max: 1e9,
  step: 1,
  soft_min: 10,
  soft_max: 5000,
  logarithmic: true,
}

function reading(at, value) {
  const fields = reader(at, value, ['name', 'title', 'symbol', 'help', 'value'])
  const name = fields.name()
  fields.code('value', true)
  return { name, symbol: fields.text('symbol', ''), title: fields.text('title', name), help: fields.text('help', ''), group: 'measure' }
}

function layer(at, value) {
  const fields = reader(at, value, ['name', 'title', 'help', 'pickable'])
  const role = fields.name()
  return { role, title: fields.text('title', role), help: fields.text('help', ''), on: true, pickable: fields.flag('pickable') }
}

function formula(at, value) {
  const fields = reader(at, value, ['name', 'title', 'tex', 'source'])
  const name = fields.name()
  return { name, source: fields.text('source', ''), title: fields.text('title', name), tex: fields.text('tex'), scope: 'iteration' }
}

function eachOnce(field, list, key) {
  const names = list.map((item) => item[key])
  const again = names.findIndex((name, k) => names.indexOf(name) < k)
  if (again >= 0) throw refused(`${field}[${again}].name`, names[again], 'a name that no other one has')
  return list
}

/** Where each candidate is a result, a planner without readings has its best cost for one. */
export function readingsOf(planner) {
  const { kinds } = planner
  const readings = planner.readings ?? []
  if (readings.length > 0 || !kinds.every((kind) => ALWAYS.includes(kind))) return readings
  return [{ name: 'cost', title: 'Best cost', help: 'The cost of the best so far.', value: (state) => planner.best(state)?.cost ?? NaN }]
}

/** A planner as the catalogue lists them. */
export function describe(planner) {
  const fields = reader('planner', planner, FIELDS)
  const name = fields.name()
  const kinds = fields.list('kinds', (at, kind) => {
    if (!KINDS.includes(kind)) throw refused(at, kind, `one of ${KINDS.join(', ')}`)
    return kind
  })
  if (kinds.length === 0) throw refused('kinds', planner.kinds, `a list of ${KINDS.join(', ')}: one of them at least`)
  const stops = kinds.includes('tour')
  if (stops && kinds.length > 1) throw refused('kinds', kinds, 'tour alone, or without it: a tour is another thing than a path')
  for (const [code, needed] of Object.entries({ start: true, advance: true, best: true, draw: false, explain: false }))
    fields.code(code, needed)
  const parameters = eachOnce('parameters', fields.list('parameters', parameter), 'name')
  if (parameters.every((known) => known.name !== ITERATIONS.name)) parameters.push(ITERATIONS)
  const readings = eachOnce('readings', fields.list('readings', reading), 'name')
  const layers = eachOnce('layers', fields.list('layers', layer), 'role')
  return {
    name,
    title: fields.text('title', name),
    family: 'own',
    source: '',
    summary: fields.text('summary', ''),
    kinds,
    stops,
    parameters: parameters.map((known) => ({ ...known, defaults: {}, kinds })),
    presets: [],
    cases: [],
    readings: readings.length > 0 ? readings : readingsOf(planner).map((one) => reading('readings[0]', one)),
    formulas: eachOnce('formulas', fields.list('formulas', formula), 'name'),
    pseudocode: [],
    // Without layers the best is drawn.
    layers: layers.length > 0 ? layers : [layer('layers[0]', { name: stops ? 'tour' : 'best', title: 'Best', help: 'The best so far.' })],
    marks: [],
    members: [],
    events: [],
  }
}
