// A module whose words its host brings, beside the one that has its English inside: under Node both say the same.
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { test } from 'node:test'
import { pattern } from '../package/fluent.mjs'
import * as whole from '../pkg/node.js'
import * as swarm from '../pkg/swarm.node.js'
import { speaker } from '../pkg/words.js'

const PLANNERS = ['pso', 'wpso', 'cpso', 'wcpso', 'qpso', 'ltqpso']
const SCENES = ['wcpso-discs', 'discs-gate', 'matyas', 'rastrigin']
const json = (path) => JSON.parse(readFileSync(new URL(path, import.meta.url), 'utf8'))
const messages = json('../pkg/locales/en.json')

/** What is thrown, by its parts. */
const refusal = (call) => {
  try {
    call()
  } catch (error) {
    const { code, message, field, value, allowed } = error
    return { code, message, field, value, allowed }
  }
  return undefined
}

test('every run has the same hash, explanations and outcome', () => {
  let told = 0
  for (const planner of PLANNERS)
    for (const scene of SCENES) {
      const setup = { planner, scene, seed: 5, params: { population: 12, iterations: 40 } }
      const [one, other] = [whole, swarm].map(({ Session }) => new Session(setup))
      while (one.status === 'running') {
        for (const index of [0, 5, 11, 12]) {
          const item = { role: 'particles', index }
          const expected = one.inspect(item)
          assert.deepEqual(other.inspect(item), expected, `${planner} on ${scene}, ${one.iteration}`)
          told += expected ? 1 : 0
        }
        one.step(3)
        other.step(3)
      }
      assert.equal(other.hash(), one.hash())
      assert.deepEqual(other.outcome(), one.outcome())
      assert.equal(other.link(), one.link())
    }
  assert.ok(told > 500, `${told} explanations`)
})

test('every refusal is the same', () => {
  const discs = (change) => ({
    format: 'forage-scene',
    version: 1,
    kind: 'discs',
    name: 'a',
    title: 'A',
    bounds: { min: [0, 0], max: [9, 8] },
    start: [0, 0],
    goal: [9, 8],
    discs: [{ center: [4, 4], radius: 1 }],
    ...change,
  })
  const run = (change) => ({ planner: 'pso', scene: 'matyas', ...change })
  const refused = [
    ({ Session }) => new Session(),
    ({ Session }) => new Session(run({ planner: 3 })),
    ({ Session }) => new Session(run({ seed: -1 })),
    ({ Session }) => new Session(run({ seed: 'x' })),
    ({ Session }) => new Session(run({ params: { population: 0 } })),
    ({ Session }) => new Session(run({ params: { population: 1e9 } })),
    ({ Session }) => new Session(run({ params: { w_max: 'a' } })),
    ({ Session }) => new Session(run({ params: { wings: 2 } })),
    ({ Session }) => new Session(run({ params: 7 })),
    ({ Session }) => new Session(run({ scene: discs({ start: [4, 4] }) })),
    ({ Session }) => new Session(run({ scene: discs({ goal: [40, 4] }) })),
    ({ Session }) => new Session(run({ scene: discs({ wall: 1 }) })),
    ({ Session }) => new Session(run({ scene: discs({ discs: [{ center: [1, 2], radius: -1 }] }) })),
    ({ Session }) => new Session(run({ scene: discs({ discs: [{ center: [1], radius: 1 }] }) })),
    ({ Session }) => new Session(run({ scene: discs({ bounds: 3 }) })),
    ({ Session }) => new Session(run({ scene: discs({ name: 5 }) })),
    ({ Session }) => new Session(run({ scene: discs({ format: 'x' }) })),
    ({ Session }) => new Session(run({ scene: { ...discs({}), kind: 'function', function: 'sphere' } })),
    ({ Session }) => Session.fromLink('#1/nonsense'),
    ({ Session }) => Session.fromLink('#9/pso/matyas'),
    ({ parseLink }) => parseLink(''),
    ({ checkScene }) => checkScene('a'),
    ({ checkParameter }) => checkParameter('pso', 'discs', 'population', 0.5),
    ({ Trial }) => new Trial(run({}), -1),
    ({ Trial }) => new Trial(run({})).step(0),
  ]
  for (const call of refused) {
    const [expected, found] = [whole, swarm].map((module) => refusal(() => call(module)))
    assert.ok(expected, `accepted: ${call}`)
    // A module knows fewer planners, kinds and scenes.
    if (expected.code === 'unknown')
      for (const one of [expected, found]) {
        delete one.message
        delete one.allowed
      }
    assert.deepEqual(found, expected, String(call))
  }
})

test('the catalogue of a module is that of the file, with the symbols of explanations', () => {
  const { symbols } = whole.catalogue()
  assert.deepEqual(whole.catalogue(), json('../pkg/catalogue.json'))
  for (const symbol of ['c_1 r_1 (p - x)', '\\tau', '\\varphi_i']) assert.ok(symbols.includes(symbol), symbol)
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

test('the module of swarms has nothing of other families, nor of arms', () => {
  const wasm = readFileSync(new URL('../pkg/swarm_bg.wasm', import.meta.url), 'latin1')
  for (const word of ['rrt-guided', 'aco-wolf', 'held-karp', 'a-star', 'hybrid-bat', 'cuboids', 'column_radius'])
    assert.ok(!wasm.includes(word), word)
  const { code, allowed } = refusal(() => new swarm.Session({ planner: 'rrt-guided', scene: 'matyas' }))
  assert.deepEqual([code, allowed], ['unknown', 'wcpso, pso, wpso, cpso, ltqpso, qpso'])
})

test('a module without words says keys', () => {
  swarm.speakBy(() => undefined)
  const { message, allowed } = refusal(() => new swarm.Session({ planner: 'pso', scene: 'matyas', seed: -1 }))
  assert.equal(message, 'error-refused')
  assert.match(allowed, /^[a-z]+-[a-z-]+$/)
  swarm.speakBy(speaker('en', json('../pkg/locales/en/swarm.json')))
})
