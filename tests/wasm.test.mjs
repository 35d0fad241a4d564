// The JavaScript face of the wasm that ships, under Node: the bits that the native tests store, and errors that are values.
import assert from 'node:assert/strict'
import { execFileSync, spawnSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { test } from 'node:test'
import { deflateRawSync } from 'node:zlib'
import {
  armPose,
  armSlice,
  armSolutions,
  catalogue,
  checkParameter,
  checkScene,
  compare,
  exportScene,
  generateScene,
  importScene,
  ModuleDead,
  newSeed,
  parseLink,
  reachability,
  Session,
  shapes,
  Trial,
} from '../pkg/node.js'

const read = (name) => readFileSync(new URL(name, import.meta.url), 'utf8')
const stored = (name) => JSON.parse(read(name))
/** A number that the native tests keep in their source. */
const constant = (file, pattern) => read(file).match(pattern)[1]

/** Parameters that stand in a stored file as the inside of a JSON object. */
const given = (set = '') => JSON.parse(`{${set}}`)

const words = new BigUint64Array(1)
const halves = new Float64Array(words.buffer)
const word = (number) => {
  halves[0] = number
  return words[0]
}

/** The digest of src/digest.rs. */
const hash = (all) => {
  const mixed = all.reduce((state, next) => {
    const product = BigInt.asUintN(64, (state ^ next) * 0x0000_0100_0000_01b3n)
    return product ^ (product >> 32n)
  }, 0xcbf2_9ce4_8422_2325n)
  return mixed.toString(16).padStart(16, '0')
}
const digest = (numbers) => hash([BigInt(numbers.length), ...Array.from(numbers, word)])
const digestOfText = (text) => {
  const bytes = Buffer.from(text)
  return hash([BigInt(bytes.length), ...Array.from(bytes, BigInt)])
}

/** What is thrown: an error with the field, or the test fails. */
const refusal = (call) => {
  try {
    call()
  } catch (error) {
    // A panic is the end of the module.
    assert.ok(error instanceof Error && !(error instanceof ModuleDead), `panics: ${call}: ${error}`)
    assert.ok(error.message)
    return error
  }
  assert.fail(`accepted: ${call}`)
}

const finished = ({ planner, scene, seed, set }) => {
  const session = new Session({ planner, scene, seed, params: given(set) })
  session.step(1e9)
  return session
}

/** A frame's buffers, copied at once: a view is empty as soon as the wasm memory has grown. */
const drawn = (session) => {
  const { vertices, spans } = session.frame()
  return { vertices: vertices.slice(), spans: spans.slice() }
}

/** A scene with a function by formula. */
const formula = (expression, dimension = 2, min = -1, max = 1) => ({
  format: 'forage-scene',
  version: 1,
  kind: 'function',
  name: 'formula',
  title: 'Formula',
  expression,
  dimension,
  bounds: { min, max },
})

test('formulas give the bits and the refusals that the native tests store', () => {
  const { runs, refusals } = stored('formulas.json')
  for (const { planner, expression, dimension, min, max, ...known } of runs) {
    const session = new Session({ planner, scene: formula(expression, dimension, min, max), seed: 7 })
    session.step(50)
    const { cost, trouble, failed_at } = session.outcome()
    assert.deepEqual({ status: session.status, hash: session.hash(), cost: word(cost).toString(16).padStart(16, '0') }, known, expression)
    assert.equal(failed_at?.length, known.status === 'failed' ? dimension : undefined)
    assert.equal(trouble !== undefined, known.status === 'failed')
    // A link carries the formula.
    const again = new Session(parseLink(session.link()))
    again.seek(50)
    assert.equal(again.hash(), known.hash)
    session.free()
    again.free()
  }
  for (const { expression, message } of refusals) {
    const error = refusal(() => new Session({ planner: 'pso', scene: formula(expression), seed: 1 }))
    assert.deepEqual([error.message, error.field, error.code], [message, 'expression', 'malformed'])
  }
})

test('functions of the suite bbob give the bits that the native tests store', () => {
  const runs = Object.entries(stored('bbob.json'))
  assert.equal(runs.length, 24)
  for (const [name, hash] of runs) {
    const scene = { format: 'forage-scene', version: 1, kind: 'function', name: 'a', title: 'A', function: name, instance: 2, dimension: 3 }
    const session = new Session({ planner: 'pso', scene, seed: 7 })
    session.step(20)
    assert.equal(session.hash(), hash, name)
    const again = new Session(parseLink(session.link()))
    again.seek(20)
    assert.equal(again.hash(), hash, name)
    session.free()
    again.free()
  }
})

test('a function from code is run, recorded and compared like one by formula, and has no link', () => {
  const bounds = { min: -5, max: [5, 6] }
  const bowl = ([x, y]) => (x - 1) ** 2 + (y + 2) ** 2 + 3
  const written = { ...formula('(x - 1)^2 + (y + 2)^2 + 3', 2), bounds }
  let calls = 0
  const scenes = {
    one: {
      dimension: 2,
      bounds,
      objective: (x) => {
        calls += 1
        return bowl(x)
      },
    },
    many: {
      ...formula('', 2),
      expression: undefined,
      bounds,
      name: 'mine',
      title: 'Mine',
      optimum: { value: 3, position: [1, -2] },
      objectives: (xs, n) => Array.from({ length: xs.length / n }, (_, k) => bowl(xs.subarray(k * n, (k + 1) * n))),
    },
  }
  delete scenes.many.expression
  for (const planner of ['pso', 'wcpso', 'qpso', 'bat-continuous', 'cuckoo-search']) {
    const by = (scene) => {
      const session = new Session({ planner, scene, seed: 4 })
      session.step(60)
      session.rewind(0)
      session.step(50)
      const { cost, position, evaluations } = session.outcome()
      return { session, found: { cost, position, evaluations, trace: session.csv() } }
    }
    const known = by(written)
    for (const scene of Object.values(scenes)) {
      const { session, found } = by(scene)
      assert.deepEqual(found, known.found, planner)
      assert.match(refusal(() => session.link()).message, /code/)
      session.free()
    }
    known.session.free()
  }
  assert.ok(calls > 1000)
  const session = new Session({ planner: 'pso', scene: scenes.many, seed: 1 })
  assert.deepEqual([session.scene.name, session.scene.objective, session.outcome().exact], ['mine', undefined, 3])
  session.free()
  const trial = new Trial({ planner: 'pso', scene: scenes.many, seed: 1 })
  trial.step(1e9)
  assert.ok(trial.record().value - 3 < 1e-6)
  trial.free()
})

test('a function from code that does wrong ends its run with the reason, or is refused', () => {
  const scene = (objective, more = {}) => ({ dimension: 1, bounds: { min: -1, max: 1 }, objective, ...more })
  const end = (scene) => {
    const session = new Session({ planner: 'pso', scene, seed: 1 })
    session.step(20)
    const { status, trouble, failed_at } = session.outcome()
    session.free()
    return { status, trouble, failed_at }
  }
  const throws = end(
    scene(([x]) => {
      if (x > 0.5) throw new RangeError('no way')
      return x
    }),
  )
  assert.equal(throws.status, 'failed')
  assert.match(throws.trouble, /throws “no way”, at \(0\.\d+\)/)
  assert.ok(throws.failed_at[0] > 0.5)
  assert.match(end(scene(() => 'much')).trouble, /gives "much" instead of a number/)
  assert.match(end(scene(() => Number.NaN)).trouble, /is not a number/)
  // Infinity is a position that is forbidden.
  assert.deepEqual(end(scene(([x]) => (x > 0 ? Number.POSITIVE_INFINITY : -x))), {
    status: 'running',
    trouble: undefined,
    failed_at: undefined,
  })
  const { objective: _one, ...empty } = scene()
  assert.match(end({ ...empty, objectives: () => [1] }).trouble, /a list of 1 instead of a list of 60 numbers/)
  assert.match(end({ ...empty, objectives: () => 1 }).trouble, /instead of a list/)
  let n = 0
  for (const [wrong, field] of [
    [scene(() => (n += 1)), 'objective'],
    [scene(() => 1, { dimension: 101 }), 'dimension'],
    [scene(() => 1, { bounds: { min: 1, max: 1 } }), 'bounds.max[0]'],
    [scene(() => 1, { optimum: { value: 0, position: [0] } }), 'optimum.value'],
    [scene(() => 1, { kind: 'grid' }), 'kind'],
    [scene(() => 1, { objectives: () => [] }), 'objective'],
    [scene(() => 1, { more: 1 }), 'more'],
    [scene(1), 'objective'],
  ])
    assert.equal(refusal(() => new Session({ planner: 'pso', scene: wrong, seed: 1 })).field, field)
  assert.equal(refusal(() => new Session({ planner: 'a-star', scene: scene(() => 1), seed: 1 })).field, 'planner')
})

test('a frame names its layers, and a field has the colours that are given', (context) => {
  globalThis.ImageData = class {
    constructor(data, width, height) {
      Object.assign(this, { data, width, height })
    }
  }
  context.after(() => delete globalThis.ImageData)
  const session = new Session({ planner: 'aco', scene: 'rooms-20', seed: 1, params: { iterations: 5 } })
  session.step(3)
  const { spans, layers } = session.frame()
  const listed = catalogue().planners.find(({ name }) => name === 'aco').layers
  assert.deepEqual(
    layers,
    listed.map(({ role }) => role),
  )
  const fields = [...spans].filter((_, i) => i % 4 === 0 && shapes[spans[i + 1]] === 'field').map((layer) => layers[layer])
  assert.deepEqual(fields, ['pheromone'])
  assert.equal(session.frame().layers, layers, 'made once')

  const of = (ramp) => [...session.layerImage('pheromone', ramp).image.data]
  const [own, listedToo] = [of(), of(listed.find(({ role }) => role === 'pheromone').look.ramp.map(({ light }) => light))]
  assert.ok(own.some((byte) => byte > 0))
  assert.deepEqual(own, listedToo)
  const [one] = [of(['#12345678', '#12345678'])]
  for (let at = 0; at < one.length; at += 4) assert.deepEqual(one.slice(at, at + 4), one[at + 3] === 0 ? [0, 0, 0, 0] : [18, 52, 86, 120])
  assert.equal(session.layerImage('best'), null)

  const refusals = [
    [true, 'ramp', 'a list'],
    [['#000000'], 'ramp', '2 to 16 colours'],
    [new Array(17).fill('#000000'), 'ramp', '2 to 16 colours'],
    [['#000000', 'red'], 'ramp[1]', 'a colour, #rrggbb or #rrggbbaa'],
    [['#000', '#ffffff'], 'ramp[0]', 'a colour, #rrggbb or #rrggbbaa'],
    [['#000000', 7], 'ramp[1]', 'a colour, #rrggbb or #rrggbbaa'],
  ]
  for (const [ramp, field, allowed] of refusals) {
    const error = refusal(() => session.layerImage('pheromone', ramp))
    assert.deepEqual({ field: error.field, allowed: error.allowed }, { field, allowed })
  }
  session.free()
})

/** Every third of the stored runs, beginning with one that the commit chooses, and one of each planner; with `scripts/test --all` every one. */
function sample(all) {
  if (process.env.FORAGE_TEST_ALL === 'true') return all
  const git = spawnSync('git', ['rev-parse', 'HEAD'], { encoding: 'utf8' })
  const first = git.status === 0 ? Number.parseInt(git.stdout.slice(0, 8), 16) % 3 : 0
  return all.filter(({ planner }, index) => index % 3 === first || planner !== all[index - 1]?.planner)
}

test('golden runs give the bits that they give natively', () => {
  const usual = Number(constant('support/mod.rs', /ITERATIONS: u32 = (\d+)/))
  const runs = stored('golden.json')
  assert.ok(runs.length >= 300)
  // Seeds of the same setup follow each other: a third has nearly every setup.
  for (const run of sample(runs)) {
    const { planner, scene, seed, set } = run
    const params = { iterations: usual, ...given(set) }
    const session = new Session({ planner, scene, seed, params })
    session.step(Math.floor(params.iterations / 2))
    const half = session.hash()
    session.step(1e9)
    const outcome = session.outcome()
    const whole = (name) => outcome[name] && digest([...outcome[name].flat(), ...(session.exact()?.[name] ?? []).flat()])
    const found = {
      ...run,
      half,
      end: session.hash(),
      cost: outcome.cost === null ? 'none' : word(outcome.cost).toString(16).padStart(16, '0'),
      paths: whole('path') ?? whole('tip_path') ?? 'none',
    }
    assert.deepEqual(found, run)
    session.free()
  }
})

test('every stored log of events is the same here', () => {
  // As Rust writes a number with all its digits.
  const digits = (number) => (Number.isInteger(number) ? `${number}.0` : String(number))
  for (const log of stored('events.json')) {
    const told = finished(log)
      .events()
      .map(({ iteration, time, place: [x, y], kind, obstacle, reason }) => {
        const about = obstacle === undefined ? '' : ` ${obstacle}`
        return `${iteration} ${digits(time)} (${digits(x)}, ${digits(y)}) ${kind}${about}: ${reason}`
      })
    assert.deepEqual(told, log.lines, `${log.planner} on ${log.scene}`)
  }
})

test('every stored drive gives the bits that it gives natively', () => {
  const drives = stored('drives.json')
  assert.ok(drives.length >= 10)
  for (const drive of drives) {
    const { rows, parameters } = finished(drive).drive({ look_ahead: drive.look_ahead })
    assert.equal(digest(rows), drive.rows, `${drive.planner} on ${drive.scene}`)
    assert.equal(parameters.look_ahead, drive.look_ahead)
  }
})

test('every stored motion gives the bits that it gives natively', () => {
  const motions = stored('motions.json')
  assert.ok(motions.length >= 10)
  for (const { set, ...motion } of motions) {
    const { rows, skeletons } = finished(motion).motion(given(set))
    assert.equal(digest([...rows, ...skeletons]), motion.rows, `${motion.planner} on ${motion.scene}`)
  }
})

test('a drive crosses as its types say', () => {
  const session = new Session({ planner: 'ltqpso', scene: 'qpso-10m' })
  session.step(50)
  const drive = session.drive()
  const entry = catalogue().drive
  assert.deepEqual(
    drive.columns,
    entry.columns.map(({ name }) => name),
  )
  assert.ok(drive.rows instanceof Float64Array)
  assert.equal(drive.rows.length % drive.columns.length, 0)
  assert.deepEqual([drive.outline.length, drive.outline.width], [0.4, 0.3])
  assert.equal(drive.outcome.arrived, true)
  assert.equal(session.outcome().drive.time, drive.outcome.time)
  assert.deepEqual(entry.parameters[0].kinds, ['grid'])
  for (const [params, field] of [
    [{ speed: 0 }, 'speed'],
    [{ speed: [] }, 'speed'],
    [{ mass: 2.3 }, 'parameter'],
    [3, 'params'],
  ])
    assert.equal(refusal(() => session.drive(params)).field, field)
  const discs = new Session({ planner: 'pso', scene: 'wcpso-discs' })
  assert.equal(discs.drive(), null)
  assert.equal(discs.outcome().drive, undefined)
})

test('a scene given as an object is the scene given by name', () => {
  const byName = new Session({ planner: 'wcpso', scene: 'wcpso-discs', seed: 4 })
  const byObject = new Session({ planner: 'wcpso', scene: byName.scene, seed: 4 })
  byName.step(50)
  byObject.step(50)
  assert.equal(byObject.hash(), byName.hash())
  assert.equal(byObject.link(), byName.link())
})

test('seeking back gives the same state and frame', () => {
  const session = new Session({ planner: 'wcpso', scene: 'wcpso-discs', params: { population: 30 } })
  session.step(37)
  const before = session.hash()
  const frame = drawn(session)
  assert.ok(frame.vertices.length % 4 === 0 && frame.spans.length % 4 === 0 && frame.spans.length > 0)
  session.step(200)
  session.seek(37)
  assert.equal(session.hash(), before)
  assert.deepEqual(drawn(session), frame)
  assert.ok(session.rewind(20) <= 20)
})

test('refusals are errors with field, value and range, and nothing panics', () => {
  const refused = (setup) => refusal(() => new Session(setup))
  const error = refused({ planner: 'pso', scene: 'sphere', params: { population: 0 } })
  assert.deepEqual([error.field, error.value], ['population', '0'])
  assert.ok(error.message.includes('100000') && error.allowed.includes('100000'))
  const disc = { format: 'forage-scene', version: 1, name: 'a', title: 'a' }
  for (const [setup, field] of [
    [{ planner: 'psso', scene: 'sphere' }, 'planner'],
    [{ planner: 'pso', scene: 'moon' }, 'scene'],
    [{ planner: 'pso', scene: 'sphere', seed: -1 }, 'seed'],
    [{ planner: 'pso', scene: 'sphere', seed: 1.5 }, 'seed'],
    [{ planner: 'pso', scene: 'sphere', params: { w: 'much' } }, 'w'],
    [{ planner: 'pso', scene: { ...disc, kind: 'function', function: 'sphere', dimension: 0 } }, 'dimension'],
  ])
    assert.equal(refused(setup).field, field, JSON.stringify(setup))
  for (const setup of [{}, [], 3, null, { planner: 3 }, { planner: 'pso' }, { planner: 'pso', scene: 7 }, { planner: 'pso', scene: {} }])
    refused(setup)
  refusal(() => parseLink('#v=7'))
  refusal(() => Session.fromLink('nothing'))
  const discs = {
    ...disc,
    kind: 'discs',
    bounds: { min: [0, 0], max: [1, 1] },
    start: [0, 0],
    goal: [1, 1],
    discs: [{ center: [0.5, 0.5], radius: 0.1 }],
  }
  checkScene(discs)
  discs.discs[0].radius = Number.NaN
  assert.equal(refusal(() => checkScene(discs)).field, 'discs[0].radius')
})

/** Lists within each other, so many deep. */
const nested = (depth) => {
  let value = []
  for (let level = 1; level < depth; level++) value = [value]
  return value
}
const disc = { format: 'forage-scene', version: 1, kind: 'function', name: 'a', title: 'a', function: 'sphere', dimension: 2 }

test('what is nested too deep is refused as natively, and the module works afterwards', () => {
  const linkTo = (text) => `#v=1&planner=pso&scene=~${deflateRawSync(text).toString('base64url')}`
  const tooDeep = 'scene: nesting deeper than 64 levels is not allowed; it must be at most 64 levels deep'
  // The scene itself is one level.
  for (const depth of [64, 6000, 100_000]) {
    const scene = { ...disc, exact: nested(depth) }
    const text = `{"exact":${'['.repeat(depth)}${']'.repeat(depth)}}`
    const calls = [
      () => new Session({ planner: 'pso', scene }),
      () => checkScene(scene),
      () => parseLink(linkTo(text)),
      () => Session.fromLink(linkTo(text)),
    ]
    for (const call of calls) assert.equal(refusal(call).message, tooDeep)
  }
  const most = { ...disc, exact: nested(63) }
  assert.equal(checkScene(most).dimension, 2)
  assert.equal(parseLink(linkTo(JSON.stringify(most))).scene.dimension, 2)

  const circle = { ...disc }
  circle.exact = circle
  assert.equal(refusal(() => checkScene(circle)).message, tooDeep)
  assert.equal(refusal(() => parseLink(linkTo(' '.repeat((4 << 20) + 1)))).value, 'a scene of more than 4194304 bytes')
  assert.equal(refusal(() => parseLink(`#v=1&planner=${'a'.repeat(4 << 20)}`)).allowed, 'at most 4194304 bytes')
  assert.equal(refusal(() => checkScene({ ...disc, exact: new Array(9_000_000) })).allowed, 'at most 8000000 values')
  assert.equal(refusal(() => checkScene({ ...disc, note: 'a'.repeat((64 << 20) + 1) })).allowed, 'at most 67108864 bytes')
  for (const [value, shown] of [
    [() => 1, 'a function'],
    [Symbol('a'), 'a symbol'],
    [new Set(), 'an iterable object'],
  ])
    assert.equal(refusal(() => checkScene({ ...disc, exact: value })).value, shown)

  const session = new Session({ planner: 'pso', scene: 'sphere' })
  session.step(3)
  assert.equal(session.iteration, 3)
})

test('findings that cannot be are refused, and the session goes on', () => {
  const params = { population: 2, seeds: 1, colony_iterations: 2, iterations: 2 }
  const session = new Session({ planner: 'pso-tuning', scene: 'wolf-ant-20', params })
  const count = session.jobs().length
  const good = { cost: 1, converged: 1, path: [[0.5, 0.5]] }
  const all = (finding) => new Array(count).fill(finding)
  for (const [findings, field] of [
    [[], 'findings'],
    [all(good).slice(1), 'findings'],
    [3, 'findings'],
    [nested(65), 'findings'],
    [all(3), 'findings[0]'],
    [all({ ...good, path: [[Number.NaN, 0]] }), 'findings[0].path[0][0]'],
    [all({ ...good, path: [[0, 1e9]] }), 'findings[0].path[0][1]'],
    [all({ ...good, path: [0] }), 'findings[0].path[0]'],
    [all({ ...good, cost: 'x' }), 'findings[0].cost'],
    [all({ ...good, converged: Number.NaN }), 'findings[0].converged'],
    [all({ ...good, more: 1 }), 'findings[0].more'],
  ])
    assert.equal(refusal(() => session.supply(findings)).field, field)
  session.supply(all({ cost: null, converged: Number.NaN, path: [] }))
  session.step(1)
  assert.equal(session.iteration, 1)
})

test('what is no count is refused by name and value, and the session goes on', () => {
  const session = new Session({ planner: 'pso', scene: 'sphere' })
  const item = (index) => ({ role: 'particles', index })
  const calls = {
    n: [
      (n) => session.step(n),
      (n) => session.advance(n),
      (n) => session.stepTo(10, n),
      (n) => new Trial({ planner: 'pso', scene: 'sphere' }).step(n),
    ],
    k: [(k) => session.seek(k), (k) => session.rewind(k)],
    evaluations: [(evaluations) => session.stepTo(evaluations)],
    after: [(after) => session.trace(after)],
    from: [(from) => session.events(from)],
    budget: [(budget) => session.frame(budget)],
    index: [(index) => session.inspect(item(index))],
  }
  for (const [field, those] of Object.entries(calls))
    for (const call of those)
      for (const [value, shown] of [
        [Number.NaN, 'NaN'],
        [-2, '-2'],
        [1.5, '1.5'],
        [2 ** 53, '9007199254740992'],
        ['x', '"x"'],
        [{}, 'an object'],
      ]) {
        const { message, ...told } = refusal(() => call(value))
        assert.deepEqual(told, { code: 'refused', field, value: shown, allowed: 'a whole number from 0 to 9007199254740991' }, message)
      }
  assert.equal(session.step(), 'running')
  assert.equal(session.iteration, 1)
  assert.equal(session.seek(Number.POSITIVE_INFINITY), 'exhausted')
  assert.equal(session.iteration, session.limit)
})

test('more members than there is memory for are refused as natively', () => {
  const points = Array.from({ length: 2000 }, (_, k) => [k % 50, Math.floor(k / 50)])
  const scene = { format: 'forage-scene', version: 1, kind: 'tour', name: 't', title: 'T', points }
  const { message: _, ...told } = refusal(() => new Session({ planner: 'tour-pso', scene, params: { population: 100_000 } }))
  const allowed = 'at most 16561 where each takes 32416 bytes of memory'
  assert.deepEqual(told, { code: 'refused', field: 'population', value: '100000', allowed })
})

test('a long step is taken in parts, with the same result', () => {
  const setup = { planner: 'sa', scene: 'random-280', params: { moves: 3000, iterations: 3 } }
  const [whole, session, trial] = [new Session(setup), new Session(setup), new Trial(setup)]
  whole.step()
  const start = session.hash()
  const advance = () => {
    const stepped = session.advance()
    assert.equal(session.partly, stepped === 'partly')
    return stepped
  }
  assert.deepEqual([advance(), session.iteration, session.link(), session.jobs()], ['partly', 0, '', []])
  assert.equal(session.rewind(0), 0)
  assert.deepEqual([session.partly, session.hash()], [false, start])
  let parts = 0
  while (advance() === 'partly') parts += 1
  assert.ok(parts > 2, `${parts} parts`)
  assert.deepEqual([session.iteration, session.hash()], [1, whole.hash()])
  assert.equal(advance(), 'partly')
  assert.equal(session.step(2), 'exhausted')
  assert.equal(whole.step(2), 'exhausted')
  assert.equal(session.hash(), whole.hash())
  let stepped
  do stepped = trial.advance(10)
  while (stepped === 'partly' || stepped === 'running')
  assert.deepEqual([stepped, trial.record().hash], ['exhausted', whole.hash()])
  assert.equal(refusal(() => session.advance(0)).field, 'n')
})

test('runs that a step needs are carried out in parts as well', () => {
  const setup = { planner: 'pso-tuning', scene: 'qpso-10m', params: { population: 2, seeds: 2, iterations: 1 } }
  const [whole, session] = [new Session(setup), new Session(setup)]
  whole.step()
  assert.deepEqual([session.advance(), session.partly, session.jobs().length], ['partly', false, 4])
  while (session.advance() === 'partly');
  assert.equal(session.hash(), whole.hash())
})

test('an object that throws while it is read is refused, and the session goes on', () => {
  const session = new Session({ planner: 'pso', scene: 'wolf-ant-20' })
  const fails = () => assert.fail('it is read')
  const hostile = [
    new Proxy({}, { ownKeys: fails, has: fails }),
    new Proxy([], { get: fails }),
    {
      get role() {
        return fails()
      },
    },
  ]
  for (const value of hostile)
    for (const call of [
      () => session.supply(value),
      () => session.supply([value]),
      () => session.inspect(value),
      () => session.lookAt(value, [1, 1]),
      () => session.drive(value),
      () => session.svg(true, value),
      () => session.pick(value, 0, 1),
      () => session.paintField(value, [0, 0], [1, 1]),
      () => session.layerImage('best', value),
      () => session.layerImage('best', [value, value]),
      () => compare(value),
      () => parseLink(value),
    ])
      try {
        call()
      } catch (error) {
        assert.equal(error.code, 'refused', `${call}: ${error.stack}`)
      }
  assert.equal(session.step(2), 'running')
  assert.equal(session.iteration, 2)
})

test('a freed object says so by name, and may be freed twice', () => {
  for (const Class of [Session, Trial]) {
    const one = new Class({ planner: 'pso', scene: 'sphere' })
    one.free()
    one.free()
    for (const use of [() => one.step(), () => one.iteration, () => one.link()])
      assert.equal(refusal(use).message, `${Class.name}: one that was freed is not allowed; it must be one that was not freed`)
  }
})

test('numbers are written as natively', () => {
  let state = 1n
  const next = () => {
    state = BigInt.asUintN(64, state * 6_364_136_223_846_793_005n + 1_442_695_040_888_963_407n)
    return state
  }
  const number = (bits) => {
    words[0] = bits
    return halves[0]
  }
  const texts = []
  for (let i = 0; i < 10_000; i++)
    for (const value of [number(next()), Number(next() >> 11n) / Number(`1e${i % 23}`)])
      texts.push(refusal(() => checkParameter('pso', 'function', 'population', value)).value)
  assert.equal(digestOfText(texts.join('\n')), constant('../src/kernel/digits.rs', /TEXTS: &str = "(\w+)"/))
})

test('the face tells everything a page needs', () => {
  assert.ok(catalogue().planners.length >= 4)
  assert.ok(catalogue().scenes.length >= 7)
  const check = (value) => checkParameter('wcpso', 'discs', 'w_max', value)
  check(0.9)
  refusal(() => check(9))
  refusal(() => check('x'))
  const seed = newSeed()
  assert.ok(seed >= 0 && Number.isInteger(seed))

  const session = new Session({ planner: 'wcpso', scene: 'wcpso-discs' })
  assert.deepEqual([session.iteration, session.limit, session.planner, session.seed], [0, 500, 'wcpso', 1])
  session.step(10)
  assert.equal(session.status, 'running')
  assert.ok(session.readings().w < 0.95)
  assert.equal(session.parameters.population, 150)
  assert.equal(session.trace(-1).iterations.length, 11)
  assert.equal(session.trace(7).iterations.length, 3)
  assert.ok(Math.abs(session.exact().length - 12.14159) < 5e-7)
  const told = session.inspect({ role: 'particles', index: 5 })
  assert.equal(told.title, 'Particle 5')
  assert.equal(told.table.rows.length, 6)
  assert.equal(session.inspect({ role: 'particles', index: 150 }), null)
  refusal(() => session.inspect({ role: 'fish', index: 1 }))
  assert.equal(session.pick(0, 0, 0.5).role, 'particles')
  assert.equal(session.pick(-50, 0, 0.5), null)
  assert.ok(session.svg(true, ['best', 'exact']).startsWith('<svg'))
  assert.equal(session.csv().trimEnd().split('\n').length, 12)
  const parsed = parseLink(session.link())
  assert.deepEqual([parsed.iteration, parsed.hash], [10, session.hash()])
  const opened = Session.fromLink(session.link())
  opened.seek(10)
  assert.equal(opened.hash(), session.hash())
})

test('random grids are the native ones and survive the way through files', () => {
  const { generators } = catalogue()
  const digests = constant('support/generated.rs', /GENERATED: \[&str; \d+\] = \[(.*?)\]/s).match(/[0-9a-f]{16}/g)
  assert.ok(digests.length >= 4)
  digests.forEach((expected, index) => {
    const { name } = generators[index]
    const scene = generateScene(name, { columns: 31, rows: 22 }, 7)
    assert.equal(digestOfText(scene.rows.join('\n')), expected, name)
    for (const [format, count] of [
      ['movingai', 2],
      ['ros', 2],
      ['json', 1],
    ]) {
      const files = exportScene(scene, format)
      assert.equal(files.length, count)
      const { scene: again, problems, notes } = importScene(files)
      assert.deepEqual(again.rows, scene.rows)
      assert.equal(problems.length, format === 'movingai' ? 1 : 0)
      assert.ok(Array.isArray(notes))
    }
  })
  const stops = generateScene('stops', { stops: 9, clusters: 2 }, 7)
  for (const [format, count] of [
    ['tsplib', 2],
    ['csv', 1],
    ['json', 1],
  ]) {
    const files = exportScene(stops, format)
    assert.equal(files.length, count)
    assert.deepEqual(importScene(files).scene.points, stops.points)
  }
  const file = (text) => [{ name: 'a.map', bytes: new TextEncoder().encode(text) }]
  const error = refusal(() => importScene(file('type octile\nheight 0\n')))
  assert.equal(error.field, 'a.map')
  assert.ok(error.message.includes('line 2: found `0`'))
  refusal(() => importScene([{ name: 'a.map', bytes: [1] }]))
  refusal(() => importScene(3))
  refusal(() => importScene(file(''), -1))
  assert.equal(refusal(() => generateScene('sand', undefined, 1)).field, 'generator')
  assert.equal(refusal(() => generateScene('maze', undefined, 0.5)).field, 'seed')
})

test('an arm tells its poses and solutions and where it can come', () => {
  const scene = 'arm-cuboid'
  const near = (found, expected, tolerance) => assert.ok(Math.abs(found - expected) < tolerance, `${found} ${expected}`)
  const tip = armPose(scene, [0, -90, 0, 0, 0, 0]).skeleton[4]
  for (const [axis, expected] of [0.895, 0.65, 0.88].entries()) near(tip[axis], expected, 1e-12)

  // Down to the start; the tip of each solution is there. Without a direction too.
  for (const direction of [[0, 0, -2], null]) {
    const { solutions, unreachable } = armSolutions(scene, [-0.2, 0.022, 0.05], direction)
    assert.ok(solutions.length > 0 && unreachable === undefined)
    near(solutions[0].skeleton[4][2], 0.05, 1e-9)
  }
  const far = armSolutions(scene, [9, 9, 9], null, [0, -90, 0, 0, 0, 0])
  assert.deepEqual([far.unreachable, far.direction], ['position', null])

  assert.equal(reachability(scene, 0.25).points.length, 4 * 7 * 6 * 3)

  // A slice through the first two joints: what is touched, and what is free.
  const home = [0, -90, 0, 0, 0, 0]
  const cells = armSlice(scene, home, [0, 1], [-170, -92], [170, 135], 0)
  assert.equal(cells.length, 64 * 64)
  const touched = cells.reduce((sum, cell) => sum + cell, 0)
  assert.ok(touched > 400 && touched < 3000, `${touched}`)
  assert.ok(armSlice(scene, home, [0, 1], [-170, -92], [170, 135], 0.05).reduce((sum, cell) => sum + cell, 0) > touched)

  const field = (call) => refusal(call).field
  assert.equal(
    field(() => reachability(scene, 0.001)),
    'step',
  )
  assert.equal(
    field(() => armPose(scene, [0, 1])),
    'joints',
  )
  assert.equal(
    field(() => armPose('wcpso-discs', [0, 0, 0, 0, 0, 0])),
    'kind',
  )
  for (const [pair, min, radius, name] of [
    [[2, 2], [0, 0], 0, 'pair'],
    [[0, 6], [0, 0], 0, 'pair'],
    [[0.5, 1], [0, 0], 0, 'pair'],
    [[0, 1], [0, NaN], 0, 'min[1]'],
    [[0, 1], [0, 0], -1, 'radius'],
  ])
    assert.equal(
      field(() => armSlice(scene, home, pair, min, [90, 90], radius)),
      name,
    )
  for (const [point, direction, joints, name] of [
    [[0, 0], null, null, 'point'],
    [[0, 0, 'a'], null, null, 'point[2]'],
    [[0, 0, 0], [0, 0, 0], null, 'direction'],
    [[0, 0, 0], [0, 0, 1], [1], 'near'],
  ])
    assert.equal(
      field(() => armSolutions(scene, point, direction, joints)),
      name,
    )
})

test('the example for Node runs', () => {
  const said = execFileSync(process.execPath, [join(import.meta.dirname, '../examples/node.mjs')], { encoding: 'utf8' })
  assert.match(said, /^\d+ planners; length [\d.]+, gap [\d.e-]+, feasible true, hash [0-9a-f]{16}\n[\d.]+ Particle 12/)
})
