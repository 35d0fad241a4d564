// Random calls of the JavaScript face, with sense and without: whatever comes in, a call returns or throws an error that says
// what is wrong, and what is alive goes on.
//   node tests/fuzz.mjs [--seed N] [--calls N | --seconds N]
import assert from 'node:assert/strict'
import { parseArgs } from 'node:util'

// Node has no canvas; what the face makes for one can be held all the same.
globalThis.ImageData ??= class {}

const face = await import('../pkg/node.js')
const { ModuleDead, Session, Trial, catalogue } = face
const { planners, scenes, generators } = catalogue()

/** A stream of random numbers (mulberry32), and what can be drawn with it. */
export function stream(seed) {
  let state = seed >>> 0
  const unit = () => {
    state = (state + 0x6d2b79f5) >>> 0
    let mixed = Math.imul(state ^ (state >>> 15), state | 1)
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61)
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32
  }
  const below = (n) => Math.floor(unit() * n)
  return { unit, below, one: (list) => list[below(list.length)], chance: (share) => unit() < share }
}

/** What nobody should give. */
const nonsense = [
  ...[undefined, null, true, '', 'x', 'é\ud800', '9'.repeat(40), Number.NaN, Number.POSITIVE_INFINITY, -1, -0, 0.5, 1e9, 2 ** 53, 1e308],
  ...[
    7n,
    Symbol('s'),
    () => 1,
    [],
    [[]],
    [1, 2],
    [Number.NaN, 1],
    {},
    { kind: 'grid' },
    { length: 3 },
    new Map([[1, 2]]),
    new Uint8Array(3),
    Object.create(Uint8Array.prototype),
    Object.create(Float64Array.prototype),
    new Proxy(new Uint8Array(3), {}),
  ],
  new Proxy([], {
    get() {
      throw new Error('no')
    },
  }),
  new Proxy(
    {},
    {
      ownKeys() {
        throw new Error('no')
      },
    },
  ),
  {
    get planner() {
      throw new Error('no')
    },
  },
]

/** A value that a parameter may have, or nearly. */
function drawnValue({ one, unit, chance }, parameter, plain = false) {
  if (!plain && chance(0.05)) return one(nonsense)
  const { type, min = 0, max = 10, soft_min: low = min, soft_max: high = max, options, default: usual } = parameter
  if (options) return one(options).value
  if (type === 'flag' || typeof usual === 'boolean') return chance(0.5)
  if (typeof usual !== 'number') return usual
  const drawn = chance(0.1) ? one([min, max, max + 1, min - 1]) : low + unit() * Math.max(Math.min(high, 30) - low, 0)
  return type === 'integer' ? Math.round(drawn) : drawn
}

/** Parameters that keep a run short: small populations and few iterations. */
const SMALL = { iterations: 12, population: 6, ants: 5, colony_iterations: 2, seeds: 1, moves: 20 }

function parametersOf(random, planner, plain) {
  const known = planner.parameters
  const given = {}
  for (const { name } of known) if (name in SMALL) given[name] = 1 + random.below(SMALL[name])
  for (let i = random.below(4); i > 0; i--) {
    const parameter = random.one(known)
    if (!(parameter.name in SMALL)) given[parameter.name] = drawnValue(random, parameter, plain)
  }
  return given
}

/** A planner on a scene, nearly always one that it takes; `plain`: shipped scenes and no spoiled part, as a command line can say it. */
export function setupOf(random, plain = false) {
  const planner = random.one(planners)
  const stops = (scene) => scene.kind === 'tour' || (scene.stops ?? []).length > 0
  const suited = scenes.filter((scene) => planner.kinds.includes(scene.kind) && (!plain || stops(scene) === planner.stops))
  const scene = random.one(random.chance(0.95) ? suited : scenes)
  const params = parametersOf(random, planner, plain)
  // Colonies and swarms take so long for roads between stops that few of the calls would be others.
  if (scene.kind === 'grid' && planner.parameters.some(({ name }) => name === 'roads') && random.chance(0.9)) params.roads ??= 'a-star'
  const setup = {
    planner: planner.name,
    scene: plain || random.chance(0.7) ? scene.name : sceneOf(random, scene.name),
    params,
    seed: random.below(1000),
  }
  if (!plain && random.chance(0.05)) setup[random.one(['planner', 'scene', 'params', 'seed'])] = random.one(nonsense)
  return setup
}

const read = new Map()
/** A shipped scene as an object, sometimes with something in it changed. */
function sceneOf(random, name) {
  if (!read.has(name)) read.set(name, JSON.stringify(face.checkScene(name)))
  const scene = JSON.parse(read.get(name))
  for (let i = random.below(3); i > 0; i--) spoil(random, scene)
  return scene
}

/** Changes something somewhere in an object. */
function spoil(random, whole) {
  let at = whole
  for (let depth = 0; depth < 6; depth++) {
    const keys = at.constructor === Object || at.constructor === Array ? Object.keys(at) : []
    if (keys.length === 0) return
    const key = random.one(keys)
    const value = at[key]
    if (value !== null && typeof value === 'object' && !nonsense.includes(value) && random.chance(0.8)) {
      at = value
      continue
    }
    if (random.chance(0.2)) delete at[key]
    else
      at[key] = typeof value === 'number' && random.chance(0.7) ? value * random.one([-1, 0.5, 2, 1e9, Number.NaN]) : random.one(nonsense)
    return
  }
}

/** Keeps the arguments of a call, or spoils one. */
function sometimes(random, args, share = 0.1) {
  if (args.length > 0 && random.chance(share)) args[random.below(args.length)] = random.one(nonsense)
  return args
}

const point = ({ unit }) => [unit() * 12 - 1, unit() * 12 - 1]

/** What is called of an object: how often, and its arguments. */
const methods = {
  step: [30, ({ below }) => [below(4)]],
  advance: [12, ({ below }) => [below(4)]],
  stepTo: [4, ({ below }) => [below(100), below(3)]],
  seek: [4, ({ below }) => [below(12)]],
  rewind: [4, ({ below }) => [below(12)]],
  readings: [4, () => []],
  trace: [4, ({ below }) => [below(10) - 1]],
  events: [2, ({ below }) => [below(5)]],
  members: [2, () => []],
  frame: [6, ({ one }) => [one([undefined, 0, 1, 50, 100_000])]],
  lookAt: [2, (random) => [point(random), point(random)]],
  layerImage: [2, ({ one }) => [one(layers), one(ramps)]],
  jobs: [2, () => []],
  supply: [
    2,
    (random, jobs) => [
      Array.from({ length: jobs }, () => ({
        cost: random.unit(),
        converged: 1,
        path: [
          [0.5, 0.5],
          [1.5, 0.5],
        ],
      })),
    ],
  ],
  outcome: [4, () => []],
  drive: [1, (random) => [random.one([undefined, { speed: random.unit() }])]],
  motion: [1, (random) => [random.one([undefined, { seed: random.below(9) }])]],
  inspect: [6, ({ one, below }) => [{ role: one(layers), index: below(9) }]],
  pick: [3, (random) => [...point(random), random.unit() * 3]],
  exact: [1, () => []],
  paintField: [1, (random) => [random.one(nonsense), point(random), point(random), random.one(ramps)]],
  csv: [1, () => []],
  hash: [3, () => []],
  link: [3, () => []],
  svg: [1, ({ chance, one }) => [chance(0.5), [one(layers), one(layers)]]],
  tourFile: [1, () => []],
  record: [3, () => []],
  curve: [3, () => []],
  free: [3, () => []],
}
const layers = [...new Set(planners.flatMap((planner) => planner.layers.map(({ role }) => role)))]
const ramps = [undefined, ['#ffffff', '#000000'], ['#f0f0f000', '#3c6058', '#3c605880'], ['red'], nonsense]
const getters = ['iteration', 'evaluations', 'limit', 'end', 'status', 'planner', 'seed', 'scene', 'parameters', 'stages']
const drawn = Object.entries(methods).flatMap(([name, [weight]]) => new Array(weight).fill(name))

/** Functions that belong to no object. */
const functions = {
  parseLink: (random, links) => [random.one(links)],
  checkScene: (random) => [sceneOf(random, random.one(scenes).name)],
  checkParameter: (random) => {
    const planner = random.one(planners)
    const parameter = random.one(planner.parameters)
    return [planner.name, random.one(planner.kinds), parameter.name, drawnValue(random, parameter)]
  },
  suggest: (random) => [setupOf(random)],
  carryOut: (random) => [{ ...setupOf(random), ...(random.chance(0.3) ? { ends: [point(random), point(random)] } : {}) }],
  newSeed: () => [],
  generateScene: (random) => {
    const generator = random.one(generators)
    return [
      generator.name,
      Object.fromEntries(generator.parameters.slice(0, 2).map((one) => [one.name, drawnValue(random, one)])),
      random.below(99),
    ]
  },
  exportScene: (random) => [sceneOf(random, random.one(scenes).name), random.one(['movingai', 'ros', 'tsplib', 'csv', 'json'])],
  importScene: (random) => {
    const name = random.one(['a.json', 'a.map', 'a.scen', 'a.tsp', 'a.tour', 'a.csv', 'a.yaml', 'a.pgm'])
    const text = random.one([
      shown(sceneOf(random, random.one(scenes).name)),
      'type octile\nheight 1\nwidth 1\nmap\n.',
      'x,y\n1,2\n3,4',
      'P5 1 1 255 a',
      '',
    ])
    const bytes = new TextEncoder().encode(text)
    if (bytes.length > 0 && random.chance(0.3)) bytes[random.below(bytes.length)] = random.below(256)
    return [[{ name, bytes }], random.one([undefined, 0, 3])]
  },
  armPose: (random) => [random.one(['arm-free', 'arm-puma', 'sphere']), Array.from({ length: 6 }, () => random.unit() * 360 - 180)],
  armSolutions: (random) => ['arm-free', [random.unit(), random.unit(), random.unit()], random.one([null, [0, 0, 1]]), undefined],
  armSlice: (random) => [
    random.one(['arm-free', 'arm-puma', 'sphere']),
    Array.from({ length: 6 }, () => random.unit() * 360 - 180),
    [random.below(7), random.below(7)],
    [-90, random.one([-90, NaN])],
    [90, 90],
    random.unit() - 0.1,
  ],
  reachability: (random) => ['arm-free', random.one([0.5, 0.9, 5])],
  compare: (random) => [
    [1, 2, 3].map((k) => ({ name: `${k}`, values: Array.from({ length: random.below(5) }, () => random.one([random.unit(), null, 1])) })),
  ],
}
const named = Object.keys(functions)

/** One call: what it was, for a report, and whether it was refused. */
function call(what, make) {
  try {
    return { value: make() }
  } catch (error) {
    const problem = () => `${what()}\n${error?.stack ?? error}`
    assert.ok(error instanceof Error && !(error instanceof ModuleDead), problem())
    assert.ok(['refused', 'unknown', 'unsupported', 'malformed'].includes(error.code), problem())
    assert.ok(error.message && typeof error.field === 'string', problem())
    return { error }
  }
}

const shown = (value) => {
  try {
    return JSON.stringify(value, (_, inner) =>
      typeof inner === 'bigint' || typeof inner === 'symbol' || Number.isNaN(inner) ? String(inner) : inner,
    )
  } catch {
    return typeof value
  }
}

/** So many random calls, or for so many seconds. Returns how many were made and refused, and how many runs were repeated. */
export function callFace({ seed, calls = Number.POSITIVE_INFINITY, seconds = Number.POSITIVE_INFINITY }) {
  const random = stream(seed)
  const until = performance.now() + 1000 * seconds
  const links = ['#v=1&planner=pso&scene=sphere&seed=1&at=3', '#v=1', '#', 'x']
  const alive = []
  let [made, refused] = [0, 0]
  let again = 0
  /** Frees an object. What was called of it has changed nothing: a new run of the same setup is at the same state. */
  const end = ({ object, setup, freed, supplied }) => {
    if (!freed && !supplied && object instanceof Session) {
      const reached = object.iteration
      object.seek(reached)
      const other = new Session(setup)
      other.seek(reached)
      assert.equal(other.hash(), object.hash(), `seed ${seed}, before call ${made}: ${shown(setup)} at ${reached}`)
      other.free()
      again += 1
    }
    object.free()
  }
  const attempt = (what, make) => {
    made += 1
    const { value, error } = call(() => `seed ${seed}, call ${made}: ${what()}`, make)
    if (error) refused += 1
    return value
  }
  while (made < calls && performance.now() < until) {
    const which = random.unit()
    if (alive.length === 0 || which < 0.04) {
      const Class = random.chance(0.8) ? Session : Trial
      const setup = setupOf(random)
      const object = attempt(
        () => `new ${Class.name}(${shown(setup)})`,
        () => new Class(setup),
      )
      if (!object) continue
      if (alive.length >= 6) {
        const [one] = alive.splice(random.below(6), 1)
        if (random.chance(0.5)) end(one)
        else one.object.free()
      }
      alive.push({ object, setup })
    } else if (which < 0.06) {
      const name = random.one(named)
      const args = sometimes(random, functions[name](random, links))
      attempt(
        () => `${name}(${args.map(shown)})`,
        () => face[name](...args),
      )
    } else if (which < 0.1) {
      const { object, setup } = random.one(alive)
      const name = random.one(getters)
      attempt(
        () => `${object.constructor.name}.${name} of ${shown(setup)}`,
        () => object[name],
      )
    } else {
      const place = random.below(alive.length)
      const { object, setup, freed } = alive[place]
      const name = random.one(drawn)
      if (!(name in object)) continue
      // A freed one is called a few times more.
      if (name === 'free') alive[place].freed = true
      else if (name === 'supply') alive[place].supplied = true
      else if (freed && random.chance(0.3)) alive.splice(place, 1)
      const jobs = name === 'supply' && !freed && random.chance(0.9) ? object.jobs().length : random.below(3)
      const args = sometimes(random, methods[name][1](random, jobs), 0.05)
      const value = attempt(
        () => `${object.constructor.name}.${name}(${args.map(shown)}) of ${shown(setup)}`,
        () => object[name](...args),
      )
      if (name === 'link' && typeof value === 'string')
        links[random.below(40)] = value.slice(0, random.chance(0.9) ? undefined : random.below(value.length))
    }
  }
  for (const one of alive) end(one)
  return { made, refused, again }
}

if (import.meta.filename === process.argv[1]) {
  const number = { type: 'string' }
  const { values } = parseArgs({ options: { seed: number, calls: number, seconds: number } })
  const seed = Number(values.seed ?? 1)
  const most = values.seconds ? { seconds: Number(values.seconds) } : { calls: Number(values.calls ?? 100_000) }
  console.log(callFace({ seed, ...most }))
}
