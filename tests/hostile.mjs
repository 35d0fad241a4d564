// Codes of planners that mean no good, or none that is good. The same in Node and in every browser: `attack` runs them all and says
// which of them got further than it may.

/** A planner that is harmless but for what is given. */
const planner = (parts = {}) => {
  const all = {
    name: "'hostile'",
    kinds: "['function']",
    start: '({ box, evaluate }) => ({ x: box.low.slice(), cost: evaluate(box.low) })',
    advance: '(state) => state',
    best: '({ x, cost }) => ({ position: x, cost })',
    ...parts,
  }
  return `register({ ${Object.entries(all)
    .map(([name, code]) => `${name}: ${code}`)
    .join(', ')} })`
}

const LOOP = '() => { for (;;); }'

/** Each is stopped by the clock. */
const ENDLESS = {
  'at once': 'for (;;);',
  'in a finally': 'try { for (;;); } finally { for (;;); }',
  'in a catch': 'for (;;) { try { for (;;); } catch {} }',
  'in start': planner({ start: LOOP }),
  'in advance': planner({ advance: LOOP }),
  'in best': planner({ best: LOOP }),
  'in a getter of the planner': 'register({ get name() { for (;;); } })',
  'in a proxy': 'register(new Proxy({}, { get() { for (;;); }, ownKeys() { for (;;); } }))',
  'in toString': planner({ name: '{ toString() { for (;;); } }', title: 'String({ toString() { for (;;); } })' }),
  'in a generator': '[...(function* () { for (;;) yield 1; })()]',
  'in promises': 'const again = () => Promise.resolve().then(again); await again()',
  'in microtasks without end': '(function again() { Promise.resolve().then(again) })(); await new Promise(() => {})',
  'in a comparison': '[...Array(9).keys()].sort(() => { for (;;); })',
  'in a replacement': "'a'.replace(/a/, () => { for (;;); })",
  'in an expression that explodes': "/^(a+)+$/.test('a'.repeat(60) + 'b')",
  'in another one': "/(x+x+)+y/.exec('x'.repeat(60))",
  'in state that is no plain data': planner({ start: '() => new Proxy({}, { ownKeys() { for (;;); }, getPrototypeOf() { for (;;); } })' }),
  'in the getter of a state': planner({ start: '() => ({ get a() { for (;;); } })' }),
  'in a sum without end': planner({ advance: '(state, { math }) => { for (;;) state.cost += math.sin(1); }' }),
}

/** Each is stopped by the memory. */
const GREEDY = {
  'typed arrays': 'const all = []; for (;;) all.push(new Float64Array(1e6))',
  'one array': 'new Uint8Array(2 ** 30)',
  'a list': 'new Array(2 ** 31 - 1).fill(0)',
  'a text': "'x'.repeat(2 ** 29)",
  'in advance': planner({ advance: '() => { const all = []; for (;;) all.push(new Float64Array(1e6)) }' }),
  'a state that grows': planner({ advance: '(state) => { (state.all ??= []).push(new Float64Array(4e6)); return state }' }),
}

/** Each is refused, or ends its run, with a message that has these words. */
const REFUSED = {
  'calls that never end': ['const down = () => down() + 1; down()', /nested too deeply/],
  'a deep text': ["JSON.parse('['.repeat(1e5))", /nested too deeply|64 MB|SyntaxError/],
  'no planner': ['1', /register/],
  'two planners': [`${planner()}; ${planner()}`, /once/],
  'what is no object': ['register(5)', /an object/],
  'a name that ships': [planner({ name: "'pso'" }), /no planner of the package/],
  'a name without end': [planner({ name: "'a'.repeat(1e6)" }), /small letters/],
  'a title without end': [planner({ title: "'a'.repeat(1e6)" }), /at most/],
  'many parameters': [planner({ parameters: "Array.from({ length: 1e4 }, (_, k) => ({ name: 'p' + k, default: 1 }))" }), /at most 100/],
  'a parameter that is a trap': [planner({ parameters: "[{ name: 'a', get default() { throw new Error('a trap') } }]" }), /a trap/],
  'a module of the system': ["import fs from 'node:fs'", /node:fs/],
  'a module from elsewhere': ["import 'https://example.org/a.js'", /only forage-lab/],
  'a module that comes later': ["await import('/pkg/node.js')", /only forage-lab/],
  'a message without end': ["throw new Error('x'.repeat(1e6))", /^.{0,700}$/],
  'a strange error': ['throw { name: {}, message: { toString: null }, get stack() { throw 1 } }', /./],
  'nothing thrown': ['throw undefined', /./],
  'a state that is no object': [planner({ start: '() => 5' }), /the state is a number/],
  'a state with a function': [planner({ start: '() => ({ a: () => 1 })' }), /state\.a is a function/],
  'a state that holds itself': [planner({ start: '() => { const a = {}; a.a = a; return a }' }), /holds itself/],
  'a best elsewhere': [planner({ best: '() => ({ position: [1e99, 0], cost: 0 })' }), /search box/],
  'a best of no length': [planner({ best: '() => ({ position: [], cost: 0 })' }), /search box/],
  'a best that is huge': [planner({ best: '() => ({ position: new Array(1e6).fill(0), cost: 0 })' }), /search box|took longer/],
  'a cost that is nothing': [planner({ best: '({ x }) => ({ position: x, cost: NaN })' }), /finite/],
  'a cost that is a text': [planner({ best: "({ x }) => ({ position: x, cost: '0' })" }), /finite/],
  'a cost that is not true': [planner({ best: '({ x }) => ({ position: x, cost: -1 })' }), /the cost/],
  'an evaluation of nothing': [planner({ advance: '(state, { evaluate }) => { evaluate([]) }' }), /evaluate/],
  'an evaluation of much': [planner({ advance: '(state, { evaluate }) => { evaluate(new Array(1e5).fill(0)) }' }), /evaluate/],
  'an evaluation of objects': [planner({ advance: '(state, { evaluate }) => { evaluate({ length: 2 }) }' }), /list of numbers/],
  'tools that are kept': [
    `let kept; ${planner({ start: '(tools) => { kept = tools; return { x: [0, 0], cost: tools.evaluate([0, 0]) } }', best: '({ x, cost }) => { kept.random(); return { position: x, cost } }' })}`,
    /only while/,
  ],
  'a search without end': ['[].indexOf.call({ length: 2 ** 53 - 1 }, 1)', /too much/],
  'a sparse list': ['const all = []; all.length = 4e9; all.includes(1)', /too much/],
  'a search for a long text': ["'a'.repeat(2e7).indexOf('a'.repeat(1e7) + 'b')", /too much/],
  'a text of nothing': ['String.raw({ raw: { length: 2 ** 50 } })', /too much/],
  'a description of its own': [`Object.prototype.toJSON = () => ({ name: '../<b>' }); ${planner()}`, /small letters/],
  'expressions of its own': [`RegExp.prototype.test = () => true; ${planner({ name: "'../<b>'" })}`, /small letters/],
  'a refusal of its own': ['register(new Proxy({}, { ownKeys() { throw { message: [1, 2], field: {} } } }))', /the code is refused/],
  'chance of its own': [planner({ advance: '() => { Math.random() }' }), /Math\.random/],
}

/** Each is harmless: it may do what it does, and nothing of the outside is there. */
const NOTHING_THERE = [
  'fetch',
  'XMLHttpRequest',
  'WebSocket',
  'Worker',
  'importScripts',
  'postMessage',
  'document',
  'window',
  'self',
  'navigator',
  'location',
  'localStorage',
  'sessionStorage',
  'indexedDB',
  'caches',
  'process',
  'require',
  'module',
  'global',
  'Buffer',
  'setTimeout',
  'setInterval',
  'setImmediate',
  'queueMicrotask',
  'requestAnimationFrame',
  'performance',
  'Date',
  'Intl',
  'WebAssembly',
  'SharedArrayBuffer',
  'Atomics',
  'std',
  'os',
  'scriptArgs',
  'print',
  'gc',
  'outside',
  'inside',
  'lent',
  'FinalizationRegistry',
]
const HARMLESS = {
  'a look around': `for (const name of ${JSON.stringify(NOTHING_THERE)}) if (name in globalThis) throw new Error(name + ' is there'); ${planner()}`,
  'a look around by a constructor': `const all = [].constructor.constructor('return this')(); for (const name of ${JSON.stringify(NOTHING_THERE)}) if (name in all) throw new Error(name + ' is there'); ${planner()}`,
  'a look around from a tool': planner({
    start: `({ random, evaluate, box }) => {
      const all = random.constructor('return this')()
      if (all !== globalThis || 'process' in all || 'fetch' in all || typeof random.caller === 'function') throw new Error('the outside is there')
      return { x: box.low.slice(), cost: evaluate(box.low) }
    }`,
  }),
  'prototypes of its own': `Object.prototype.polluted = 1; Array.prototype.map = () => 'mine'; Function.prototype.call = () => 'mine'; ${planner()}`,
  'iterators of its own': planner({
    advance: '(state) => { Array.prototype[Symbol.iterator] = () => { throw new Error("mine") }; return state }',
  }),
  'prototypes in what it says': `const said = JSON.parse('{"__proto__": {"polluted": 1}}'); ${planner({ summary: "String(said.polluted ?? '')" })}`,
  'JSON of its own': `JSON.stringify = () => '{"code":"mine"}'; JSON.parse = () => { throw new Error('mine') }; ${planner()}`,
  'lists of its own': planner({
    layers: "[{ name: 'particles', pickable: true }]",
    draw: "({ x }, pen) => { Float64Array.prototype.set = function () { this.fill(-3) }; pen.points('particles', [x]) }",
  }),
  'explanations of its own': planner({
    layers: "[{ name: 'best', pickable: true }]",
    explain: "() => { Object.entries = () => ({ filter: () => null }); return { summary: 'a' } }",
  }),
  'an entry of its own': `Array.prototype.map = () => 5; ${planner()}`,
  'mathematics of its own': `Math.sin = () => 7; Math.sqrt = () => 7; ${planner()}`,
  'much that is printed': `for (let k = 0; k < 5000; k += 1) console.log('x'.repeat(5000)); ${planner()}`,
  'odd things that are printed': `console.log({ toString() { throw 1 }, toJSON() { throw 2 } }, Symbol('a'), 1n, undefined, null, () => 1, new Proxy({}, {})); ${planner()}`,
}

/** What may only be drawn or said wrongly: the run goes on. */
const ODD = {
  'draws for ever': { layers: "[{ name: 'particles', pickable: true }]", draw: LOOP },
  'draws too much': {
    layers: "[{ name: 'particles', pickable: true }]",
    draw: "(_, pen) => { for (;;) pen.points('particles', Array.from({ length: 1e5 }, () => [0, 0])) }",
  },
  'draws nothing that is': {
    layers: "[{ name: 'particles', pickable: true }]",
    draw: "(_, pen) => pen.points('particles', [[NaN, Infinity], ['a', {}], []])",
  },
  'explains for ever': { layers: "[{ name: 'best', pickable: true }]", explain: LOOP },
  'explains too much': {
    layers: "[{ name: 'best', pickable: true }]",
    explain:
      "() => ({ title: 'x'.repeat(1e6), summary: 'y'.repeat(1e6), values: Object.fromEntries(Array.from({ length: 1e5 }, (_, k) => ['v' + k, k])) })",
  },
  'reads for ever': { readings: `[{ name: 'a', value: ${LOOP} }]` },
  'reads what is no number': { readings: "[{ name: 'a', value: () => ({ valueOf() { throw new Error('mine') } }) }]" },
}

/** At most so long may a code be at it that is stopped by the clock, in milliseconds: a second, and what a busy machine needs. */
const SOON = 2500
const LINES = 200

/**
 * Runs all of it.
 * @param registerCode of `forage-lab/isolate`
 * @param Session of `forage-lab`
 * @param ontry is given each code before it is tried
 * @returns what got further than it may, in words
 */
export async function attack({ registerCode, Session, ontry = () => undefined }) {
  const wrong = []
  let attacks = 0
  const harmless = () => {
    const session = new Session({ planner: 'pso', scene: 'sphere-2', seed: 1 })
    session.step(5)
    const hash = session.hash()
    session.free()
    return hash
  }
  const before = harmless()
  // The interpreter is fetched and compiled once: that is no part of what a code takes.
  await registerCode(planner())
  /** Registers a code and runs it; gives the error, or how the run ended. */
  const tried = async (code) => {
    attacks += 1
    ontry(code)
    const began = performance.now()
    const lines = []
    let found
    let session
    try {
      const { name, layers } = await registerCode(code, { onprint: (line) => lines.push(line) })
      session = new Session({ planner: name, scene: 'sphere-2', seed: 1 })
      session.step(30)
      session.frame()
      session.readings()
      for (const { role, pickable } of layers) if (pickable) session.inspect({ role, index: 0 })
      const { status, trouble } = session.outcome()
      found = { status, said: trouble }
    } catch (error) {
      found = { said: error instanceof Error ? error.message : `not an error: ${error}`, stopped: error.stopped }
    }
    session?.free()
    return { ...found, took: performance.now() - began, lines }
  }
  const expect = (title, holds, found) => {
    if (!holds) wrong.push(`${title}: ${JSON.stringify(found).slice(0, 300)}`)
    if ({}.polluted !== undefined) wrong.push(`${title}: it changes prototypes outside`)
    if (harmless() !== before) wrong.push(`${title}: afterwards other runs are other ones`)
  }
  for (const [title, code] of Object.entries(ENDLESS)) {
    const found = await tried(code)
    expect(
      `endless ${title}`,
      /took longer than|64 MB|is no plain data|is a |small letters|must be/.test(found.said) && found.took < SOON,
      found,
    )
  }
  for (const [title, code] of Object.entries(GREEDY)) {
    const found = await tried(code)
    expect(`greedy: ${title}`, /64 MB|took longer|Error/.test(found.said), found)
  }
  for (const [title, [code, words]] of Object.entries(REFUSED)) {
    const found = await tried(code)
    expect(title, (found.status === undefined || found.status === 'failed') && words.test(found.said), found)
  }
  for (const [title, code] of Object.entries(HARMLESS)) {
    const found = await tried(code)
    expect(
      title,
      !/is there/.test(found.said ?? '') && found.lines.length <= LINES && found.lines.every((line) => line.length <= 1000),
      found,
    )
  }
  for (const [title, parts] of Object.entries(ODD)) {
    const found = await tried(planner(parts))
    expect(title, found.status === 'running' || found.status === 'exhausted', found)
  }
  return { wrong, attacks }
}
