// A session in a thread of Node: the members of Session, with the same answers and refusals, one after another.
import assert from 'node:assert/strict'
import { spawnSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { test } from 'node:test'
import { Worker } from 'node:worker_threads'
import { Session } from '../pkg/node.js'
import { ModuleDead, WorkerSession } from '../pkg/worker.node.js'

const setup = { planner: 'aco', scene: 'rooms-20', seed: 3, params: { iterations: 20 } }

test('it has every member of a session, and gives the same', async () => {
  const inner = (name) => name.startsWith('__')
  const members = ({ prototype }) => Reflect.ownKeys(prototype).filter((name) => typeof name === 'symbol' || !inner(name))
  assert.deepEqual(new Set(members(WorkerSession)), new Set(members(Session)))

  const statics = (of) =>
    Object.getOwnPropertyNames(of).filter((name) => typeof of[name] === 'function' && !inner(name) && name !== 'start')
  assert.deepEqual(statics(WorkerSession), statics(Session))

  const here = new Session(setup)
  const there = await WorkerSession.start(setup)
  assert.equal(await there.step(7), here.step(7))
  for (const name of ['iteration', 'evaluations', 'limit', 'end', 'status', 'partly', 'planner', 'seed', 'scene', 'parameters', 'stages'])
    assert.deepEqual(await there[name], here[name], name)
  const calls = {
    outcome: [],
    readings: [],
    curve: [],
    members: [],
    trace: [-1],
    inspect: [{ role: 'ants', index: 1 }],
    pick: [0.5, 0.5, 20],
    exact: [],
    svg: [false, ['best']],
    link: [],
    hash: [],
    csv: [],
    frame: [],
  }
  for (const [name, given] of Object.entries(calls)) assert.deepEqual(await there[name](...given), here[name](...given), name)
  assert.equal(await there.seek(3), here.seek(3))
  assert.equal(await there.hash(), here.hash())
  const linked = await WorkerSession.fromLink(here.link())
  assert.deepEqual([await linked.iteration, await linked.seek(3), await linked.hash()], [0, 'running', here.hash()])
  linked.free()
  there.free()
  here.free()
})

test('what a frame brings lasts, and so does the session', async () => {
  const session = await WorkerSession.start({ planner: 'wcpso', scene: 'wcpso-discs' })
  const first = await session.frame()
  const kept = first.vertices.slice()
  await session.step(50)
  const second = await session.frame()
  assert.deepEqual(first.vertices, kept)
  assert.notDeepEqual(second.vertices, kept)
  assert.ok(second.vertices.buffer.byteLength === second.vertices.byteLength, 'without the module’s memory')
  session.free()
})

test('what is refused has its fields, and calls are answered in their order', async () => {
  await assert.rejects(WorkerSession.start({ ...setup, planner: 'acco' }), { code: 'unknown', field: 'planner', value: 'acco' })
  const scene = { dimension: 1, bounds: { min: 0, max: 1 }, objective: ([x]) => x }
  await assert.rejects(WorkerSession.start({ planner: 'pso', scene }), { field: 'scene.objective' })
  assert.throws(() => new WorkerSession(), TypeError)
  const session = await WorkerSession.start(setup)
  const answer = await Promise.all([
    session.step(2),
    session.iteration,
    session.step(Number.NaN).catch(({ code, field, value, message }) => ({ code, field, value, message })),
    // It needs a part of the module that is not there yet.
    session.svg(true, ['best']).then((text) => text.slice(0, 4)),
    session.step(3),
    session.iteration,
  ])
  const refused = { code: 'refused', field: 'n', value: 'NaN' }
  const { message } = answer[2]
  assert.match(message, /^n: NaN is not allowed; it must be a whole number/)
  assert.deepEqual(answer, ['running', 2, { ...refused, message }, '<svg', 'running', 5])
  await assert.rejects(session.paintField({}, [0, 0], [1, 1]), { code: 'refused', field: 'ctx' })
  session.free()
})

test('to free it ends what it is at, and says so of every later call', async () => {
  const session = await WorkerSession.start({ planner: 'sa', scene: 'random-280', params: { moves: 100_000, iterations: 100_000 } })
  const gone = { code: 'refused', field: 'WorkerSession', message: /^WorkerSession: one that was freed is not allowed/ }
  const long = assert.rejects(session.step(Infinity), gone)
  session.free()
  session.free()
  await long
  await assert.rejects(session.hash(), gone)
  await assert.rejects(session.status, gone)
})

test('it speaks by the words that it is given', async () => {
  const patterns = JSON.parse(readFileSync(new URL('../pkg/locales/en.json', import.meta.url), 'utf8'))
  const words = { locale: 'en', patterns: { ...patterns, 'error-whole-from-to': 'between { $min } and { $max }' } }
  const session = await WorkerSession.start(setup, { words })
  await assert.rejects(session.step(-1), { allowed: 'between 0 and 9007199254740991' })
  session.free()
})

/** A thread in which the module has no memory left. */
const full = () => {
  const module = (name) => JSON.stringify(new URL(`../pkg/${name}`, import.meta.url).href)
  return new Worker(
    `import(${module('glue.js')}).then(async ({ initSync }) => {
       await import(${module('session-worker.node.js')});
       const { memory } = initSync();
       memory.grow(65536 - memory.buffer.byteLength / 65536);
     })`,
    { eval: true },
  )
}

test('a module that breaks down, and a thread that does, end one session only', async () => {
  const worker = full()
  const large = { planner: 'pso', scene: 'wcpso-discs', params: { population: 5000 } }
  await assert.rejects(WorkerSession.start(large, { worker }), (error) => {
    assert.ok(error instanceof ModuleDead && error instanceof Error)
    assert.equal(error.code, 'module-dead')
    assert.match(String(error.cause), /unreachable/)
    return true
  })
  const broken = new Worker('throw new Error("no such luck")', { eval: true })
  await assert.rejects(WorkerSession.start(setup, { worker: broken }), /^Error: WorkerSession: the worker broke down: no such luck$/)
  const silent = new Worker('', { eval: true })
  await assert.rejects(
    WorkerSession.start(setup, { worker: silent }),
    /^Error: WorkerSession: the worker broke down: it ended with code 0$/,
  )
  const session = await WorkerSession.start(setup)
  assert.equal(await session.step(1), 'running')
  session.free()
})

test('Node ends when nothing is waited for, freed or not', () => {
  const entry = JSON.stringify(new URL('../pkg/worker.node.js', import.meta.url).href)
  const code = `import { WorkerSession } from ${entry};
    const session = await WorkerSession.start(${JSON.stringify(setup)});
    await session.step(5);
    console.log(await session.iteration);`
  const { stdout, status } = spawnSync('node', ['--input-type=module', '--eval', code], { encoding: 'utf8', timeout: 60_000 })
  assert.deepEqual([stdout, status], ['5\n', 0])
})

test('a planner of one’s own goes to the thread as code', async () => {
  const code = readFileSync(new URL('../templates/hill-climber.js', import.meta.url), 'utf8')
  const { registerCode } = await import('../pkg/isolate.node.js')
  await registerCode(code)
  const own = { planner: 'my-hill-climber', scene: 'sphere-2', seed: 3 }
  const here = new Session(own)
  const there = await WorkerSession.start(own, { code })
  here.step(20)
  await there.step(20)
  assert.equal(await there.hash(), here.hash())
  there.free()
  await assert.rejects(WorkerSession.start(own), /my-hill-climber/)
  await assert.rejects(WorkerSession.start(own, { code: 'register({' }), /SyntaxError/)
})
