// The module's parts, and the words that its host brings.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { pattern } from '../package/fluent.mjs'
import { described } from '../package/texts.js'
import { made, untold } from './support/messages.mjs'
import { catalogue, partsOf } from '../pkg/node.js'
import { speaker } from '../pkg/words.js'

const json = (path) => JSON.parse(readFileSync(new URL(path, import.meta.url), 'utf8'))
const messages = json('../pkg/locales/en.json')

test('the catalogue is that of the file, with the symbols of explanations', () => {
  const { symbols } = catalogue()
  assert.deepEqual(catalogue(), json('../pkg/catalogue.json'))
  for (const symbol of ['c_1 r_1 (p - x)', '\\tau', '\\varphi_i']) assert.ok(symbols.includes(symbol), symbol)
})

const root = fileURLToPath(new URL('..', import.meta.url))
const english = { ...messages, ...described(json('../pkg/catalogue.json')) }

test('every message that the sources make has English, and no text of the catalogue is empty', () => {
  const sources = ['src', 'crates/face/src', 'crates/module/src'].flatMap((folder) =>
    readdirSync(join(root, folder), { recursive: true })
      .filter((file) => file.endsWith('.rs'))
      .map((file) => readFileSync(join(root, folder, file), 'utf8')),
  )
  // The examples of the documentation.
  const keys = sources.flatMap(made).filter((key) => !key.startsWith('demo-'))
  assert.ok(keys.length > 400, `${keys.length} messages`)
  assert.deepEqual(untold(keys, english), [])
  assert.deepEqual(untold(made('message!(\n  "no-such", "", n)'), { 'is-empty': ' ', told: 'Told.' }), ['is-empty', 'no-such'])
})

test('every message can be said, with all its plurals and numbers', () => {
  const say = speaker('en', messages)
  for (const [key, text] of Object.entries(messages)) {
    const names = [...text.matchAll(/\$([a-z_][a-z0-9_]*)/g)].map(([, name]) => name)
    for (const value of [1, 2, 0.5]) {
      const said = say(key, Object.fromEntries(names.map((name) => [name, value])))
      assert.ok(said && !said.includes('{') === !text.includes('{ "{" }'), `${key}: ${said}`)
    }
  }
})

test('numbers are written as natively: all digits, or so many, halves to even', () => {
  const say = speaker('en', {
    all: pattern({ key: 'all', english: '{x}' }),
    one: pattern({ key: 'one', english: '{x:.1}' }),
    none: pattern({ key: 'none', english: '{x:.0}' }),
    stops: pattern({ key: 'stops', english: '{{{n}}} {s}', plurals: [['s', 'stop', 'stops']] }),
  })
  const all = [
    [0.1, '0.1'],
    [1e21, '1000000000000000000000'],
    [1.5e-7, '0.00000015'],
    [-0, '-0'],
    [123456789, '123456789'],
    [5e-324, `0.${'0'.repeat(323)}5`],
  ]
  for (const [x, text] of all) assert.equal(say('all', { x }), text)
  const one = [
    [0.25, '0.2'],
    [0.35, '0.3'],
    [0.75, '0.8'],
    [-0.04, '-0.0'],
    [2, '2.0'],
    [1234.56, '1234.6'],
    [0.05, '0.1'],
  ]
  for (const [x, text] of one) assert.equal(say('one', { x }), text)
  for (const [x, text] of [
    [0.5, '0'],
    [1.5, '2'],
    [2.5, '2'],
    [-0.5, '-0'],
    [99.5, '100'],
  ])
    assert.equal(say('none', { x }), text)
  assert.equal(say('stops', { n: 1, s: 1 }), '{1} stop')
  assert.equal(say('stops', { n: 3, s: 3 }), '{3} stops')
})

/** What a script prints in a process of its own: nothing is loaded there. */
const alone = (script) =>
  JSON.parse(
    execFileSync(process.execPath, ['--input-type=module', '--eval', script], { cwd: new URL('..', import.meta.url), encoding: 'utf8' }),
  )

test('the first part has nothing of other families, nor of arms', () => {
  const wasm = readFileSync(new URL('../pkg/forage_bg.wasm', import.meta.url), 'latin1')
  for (const word of ['rrt-guided', 'aco-wolf', 'held-karp', 'a-star', 'hybrid-bat', 'cuboids', 'column_radius'])
    assert.ok(!wasm.includes(word), word)
})

test('no part has English inside', () => {
  for (const file of readdirSync(new URL('../pkg', import.meta.url)).filter(
    (name) => name.endsWith('.wasm') && name !== 'interpreter.wasm',
  )) {
    const wasm = readFileSync(new URL(`../pkg/${file}`, import.meta.url), 'latin1')
    for (const word of ['is not allowed', 'there is no `', 'a whole number from', 'keeps part of its velocity'])
      assert.ok(!wasm.includes(word), `${file}: ${word}`)
  }
})

test('parts come when a call needs them, in any order, and are offered in the order of the catalogue', () => {
  const { planners, scenes } = json('../pkg/catalogue.json')
  const told = alone(`
    import { checkParameter, checkScene, Session } from './pkg/node.js'
    const [rrt, ant, sa] = [['rrt-guided', 'arm-bench'], ['aco', 'ant-bat-30'], ['sa', 'random-52']].map(([planner, scene]) => {
      const session = new Session({ planner, scene })
      session.step(2)
      return session.hash()
    })
    const known = (call) => { try { call() } catch ({ code, allowed }) { return [code, allowed] } }
    console.log(JSON.stringify({ rrt, ant, sa, planners: known(() => checkParameter('x')), scenes: known(() => checkScene('x')) }))`)
  assert.deepEqual(told.planners, ['unknown', planners.map(({ name }) => name).join(', ')])
  assert.deepEqual(told.scenes, ['unknown', scenes.map(({ name }) => name).join(', ')])
  for (const name of ['rrt', 'ant', 'sa']) assert.match(told[name], /^[0-9a-f]{16}$/)
})

test('what a run needs is known by name before it is loaded', () => {
  const grid = { format: 'forage-scene', version: 1, kind: 'grid' }
  const cases = [
    [{ planner: 'wcpso', scene: 'wcpso-discs' }, []],
    [{ planner: 'pso', scene: grid }, ['grid']],
    [{ planner: 'a-star', scene: 'ant-bat-30' }, ['grid']],
    [{ planner: 'rrt', scene: 'arm-bench' }, ['arm']],
    [{ planner: 'held-karp', scene: 'random-52', params: { roads: 'rrt' } }, ['tour', 'grid', 'arm']],
    [{ planner: 'x', scene: 'y' }, []],
    [{ planner: 'toString', scene: { kind: 'constructor' } }, []],
  ]
  for (const [setup, parts] of cases) assert.deepEqual(partsOf(setup), parts, JSON.stringify(setup))
})

test('a host that brings no part learns which one is needed', () => {
  const told = alone(`
    import { checkScene, initSync, parseLink, Session, speakBy } from './pkg/glue.js'
    import { addScenes, askBy, share } from './pkg/loader.js'
    import { readFileSync } from 'node:fs'
    share(initSync({ module: readFileSync('pkg/forage_bg.wasm') }))
    addScenes('swarm', JSON.parse(readFileSync('pkg/scenes/swarm.json')))
    speakBy((key, args) => key + ' ' + Object.values(args).join(' '))
    askBy((parts, known) => known ? parts.join() : undefined)
    const grid = { format: 'forage-scene', version: 1, kind: 'grid' }
    const calls = [() => new Session({ planner: 'dijkstra', scene: 'matyas' }), () => checkScene('ant-bat-30'), () => checkScene(grid), () => parseLink('#'), () => checkScene('x')]
    console.log(JSON.stringify(calls.map((call) => { try { call() } catch ({ code, field, value, allowed }) { return [code, field, value, allowed] } })))`)
  assert.deepEqual(told.slice(0, 4), [
    ['not-loaded', 'planner', 'dijkstra', 'error-part-loaded grid'],
    ['not-loaded', 'scene', 'ant-bat-30', 'error-part-loaded grid'],
    ['not-loaded', 'kind', 'grid', 'error-part-loaded grid'],
    ['not-loaded', 'tool', 'links', 'error-part-loaded links'],
  ])
  assert.deepEqual(told[4].slice(0, 3), ['unknown', 'scene', 'x'])
})

test('without words keys are said', () => {
  const { message, allowed } = alone(`
    import { Session, speakBy } from './pkg/node.js'
    speakBy(() => undefined)
    try { new Session({ planner: 'pso', scene: 'matyas', seed: -1 }) } catch ({ message, allowed }) { console.log(JSON.stringify({ message, allowed })) }`)
  assert.equal(message, 'error-refused')
  assert.match(allowed, /^[a-z]+-[a-z-]+$/)
})
