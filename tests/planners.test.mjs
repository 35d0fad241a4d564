// Planners in JavaScript: all that planners of the package have, what is refused, and what the conformance suite says in words.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { compare, parseLink, register, reset, Session, Trial } from '../pkg/node.js'
import { conform } from '../pkg/testing.node.js'

/** The hill climber of the contract. */
const climber = (more = {}) => ({
  name: 'hill-climber',
  title: 'Hill climber',
  kinds: ['function'],
  parameters: [{ name: 'step', symbol: 's', default: 0.05, min: 0.001, max: 1, help: 'Of the box’s side.' }],
  readings: [{ name: 'cost', title: 'Cost', value: ({ cost }) => cost }],
  layers: [{ name: 'particles', title: 'Climber', pickable: true }],
  start({ box, evaluate, random }) {
    const position = box.low.map((low, k) => low + (box.high[k] - low) * random())
    return { position, cost: evaluate(position), tried: 0 }
  },
  advance(state, { box, evaluate, normal, params, math }) {
    const step = (low, high) => params.step * (high - low) * normal()
    const position = state.position.map((x, k) => math.min(box.high[k], math.max(box.low[k], x + step(box.low[k], box.high[k]))))
    const cost = evaluate(position)
    return cost < state.cost ? { position, cost, tried: state.tried + 1 } : { ...state, tried: state.tried + 1 }
  },
  best: ({ cost, position }) => ({ cost, position }),
  draw: ({ position }, pen) => pen.points('particles', [position]),
  explain: ({ tried, cost }, { index }) => ({ title: `Climber ${index}`, summary: 'It goes on.', values: { tried, cost } }),
  ...more,
})

const refusal =
  (field, ...words) =>
  (error) => {
    assert.equal(error.field, field, error.message)
    for (const word of words) assert.ok(error.message.includes(word), `${error.message} has not "${word}"`)
    return true
  }

test('a hill climber has what planners have', async () => {
  const described = await register(climber())
  assert.deepEqual([described.family, described.parameters.map(({ name }) => name)], ['own', ['step', 'iterations']])
  const setup = { planner: 'hill-climber', scene: 'sphere', params: { step: 0.02 }, seed: 5 }
  const session = new Session(setup)
  const first = session.hash()
  session.step(300)
  const { hash, cost, evaluations, deterministic, exact, position } = session.outcome()
  assert.deepEqual([evaluations, deterministic, exact], [301, false, 0])
  assert.equal(
    position.reduce((sum, x) => sum + x * x, 0),
    cost,
  )
  assert.equal(session.readings().cost, cost)
  const item = { role: 'particles', index: 0 }
  const { title, values } = session.inspect(item)
  assert.deepEqual(
    [title, values.map(({ name, title, value }) => [name, title, value])],
    [
      'Climber 0',
      [
        ['tried', 'tried', 300],
        ['cost', 'cost', cost],
      ],
    ],
  )
  session.seek(0)
  assert.equal(session.hash(), first)
  session.seek(300)
  assert.equal(session.hash(), hash, 'the way back and forth')
  const link = session.link()
  assert.equal(parseLink(link).planner, 'hill-climber')
  const opened = Session.fromLink(link)
  opened.seek(300)
  assert.equal(opened.hash(), hash)
  session.step(1e6)
  assert.deepEqual([session.iteration, session.outcome().status], [1000, 'exhausted'])
  // The same bits everywhere: this is the run's hash in every engine.
  assert.equal(hash, HASH)
})
const HASH = 'c2a74751532f592b'

test('trials are measured and compared with published planners', async () => {
  await register(climber())
  const valuesOf = (planner) =>
    [1, 2, 3, 4, 5].map((seed) => {
      const trial = new Trial({ planner, scene: 'sphere-2', seed })
      while (trial.step(100) === 'running') {}
      const { value, evaluations, hash } = trial.record()
      assert.ok(Number.isFinite(value) && evaluations > 1000 && hash)
      return value
    })
  const groups = ['hill-climber', 'pso'].map((name) => ({ name, values: valuesOf(name) }))
  assert.deepEqual(
    compare(groups).groups.map(({ name, runs }) => [name, runs]),
    [
      ['hill-climber', 5],
      ['pso', 5],
    ],
  )
})

test('paths and tours are planned, and what is no solution ends the run', async () => {
  const straight = {
    name: 'straight',
    kinds: ['discs', 'grid'],
    start: ({ scene, evaluate, isFree }) => ({
      path: [scene.start, scene.goal],
      cost: evaluate([scene.start, scene.goal]),
      free: isFree(scene.start, scene.goal),
    }),
    advance: (_, { finish }) => finish(),
    best: ({ path, cost, free }) => (free ? { path, cost } : null),
  }
  await register(straight)
  const session = new Session({ planner: 'straight', scene: 'qpso-10m-empty' })
  session.step(10)
  const { iterations, status, length, exact } = session.outcome()
  assert.deepEqual([iterations, status, length], [1, 'exhausted', exact])
  await register({
    name: 'in-order',
    kinds: ['tour'],
    start: ({ scene, evaluate, distance }) => {
      const order = scene.points.map((_, k) => k)
      return { order, cost: evaluate(order), first: distance(0, 1) }
    },
    advance() {},
    best: ({ order, cost }) => ({ order, cost }),
  })
  const tour = new Session({ planner: 'in-order', scene: 'open-12' })
  tour.step(1)
  assert.equal(tour.outcome().length, tour.outcome().cost)
  await register({
    ...straight,
    name: 'elsewhere',
    best: () => ({
      cost: 1,
      path: [
        [0, 0],
        [1, 1],
      ],
    }),
  })
  assert.throws(() => new Session({ planner: 'elsewhere', scene: 'qpso-10m-empty' }), /no path from the start to the goal/)
  await register(climber({ name: 'outside', best: () => ({ cost: 1, position: [1e9] }) }))
  assert.throws(() => new Session({ planner: 'outside', scene: 'sphere-2' }), /no position in the search box/)
})

test('a run goes on with its code when another one of its name comes, and a restart keeps the newest', async () => {
  await register(climber())
  const setup = { planner: 'hill-climber', scene: 'sphere-2', seed: 4 }
  const [before, alone] = [new Session(setup), new Session(setup)]
  alone.step(60)
  before.step(30)
  await register(climber({ advance: (state) => state }))
  before.seek(0)
  before.seek(60)
  assert.equal(before.hash(), alone.hash())
  const still = new Session(setup)
  still.step(60)
  assert.equal(still.outcome().evaluations, 1)
  before.free()
  alone.free()
  reset()
  const after = new Session(setup)
  after.step(60)
  assert.equal(after.outcome().evaluations, 1)
})

test('a cost where the function has none is not believed', async () => {
  await register(climber({ name: 'believer', start: () => ({ position: [0, 0], cost: 1, tried: 0 }) }))
  const scene = { dimension: 2, bounds: { min: -1, max: 1 }, objective: ([x]) => (x === 0 ? Number.NaN : x) }
  assert.throws(() => new Session({ planner: 'believer', scene }), /is said to be 1; it is NaN/)
})

test('code that throws ends the run with its words', async () => {
  await register(
    climber({
      name: 'thrower',
      advance(state) {
        if (state.tried === 3) throw new Error('the fourth is too much')
        return { ...state, tried: state.tried + 1 }
      },
    }),
  )
  const session = new Session({ planner: 'thrower', scene: 'sphere-2' })
  session.step(10)
  const { status, trouble, iterations } = session.outcome()
  assert.deepEqual([status, iterations], ['failed', 4])
  assert.match(trouble, /the fourth is too much/)
})

test('what is lent is lent to `start` and `advance` only', async () => {
  let kept
  const start = (tools) => {
    kept = tools
    return { position: [0, 0], cost: 0, tried: 0 }
  }
  await register(climber({ name: 'keeper', start }))
  new Session({ planner: 'keeper', scene: 'sphere-2' })
  assert.throws(() => kept.random(), refusal('tools', '`start` or `advance`'))
  assert.equal(kept.math.sin(1), 0.8414709848078965, 'mathematics is always there')
})

test('what an author says is checked', async () => {
  for (const [more, field, ...words] of [
    [{ name: 'Big' }, 'name', '"Big"', 'small letters'],
    [{ name: 'pso' }, 'name', 'no planner of the package'],
    [{ title: 5 }, 'title', '5', 'a text'],
    [{ kinds: [] }, 'kinds', 'one of them at least'],
    [{ kinds: ['arm'] }, 'kinds[0]', '"arm"', 'function, discs, grid, tour'],
    [{ kinds: ['tour', 'grid'] }, 'kinds', 'tour alone'],
    [{ advance: undefined }, 'advance', 'nothing', 'a function'],
    [{ draw: 3 }, 'draw', '3', 'a function'],
    [{ more: 1 }, 'more', 'left out'],
    [{ parameters: [{ name: 'a' }] }, 'parameters[0].default', 'nothing', 'a number from'],
    [{ parameters: [{ name: 'a', default: 5, max: 4 }] }, 'parameters[0].default', '5', 'to 4'],
    [{ parameters: [{ name: 'a', default: 5, min: 9, max: 4 }] }, 'parameters[0].max', 'at least min = 9'],
    [{ parameters: [{ name: 'a', default: 1.5, integer: true }] }, 'parameters[0].default', 'a whole number'],
    [{ parameters: [{ name: 'a', default: 'x', options: ['y', 'z'] }] }, 'parameters[0].default', 'one of y, z'],
    [{ parameters: [1, 2].map((n) => ({ name: 'a', default: n })) }, 'parameters[1].name', 'no other'],
    [{ readings: [{ name: 'a' }] }, 'readings[0].value', 'a function'],
    [{ layers: [{ name: 'a', size: 1 }] }, 'layers[0].size', 'left out'],
    [{ formulas: [{ name: 'a' }] }, 'formulas[0].tex', 'a text'],
  ])
    await assert.rejects(register(climber(more)), refusal(field, ...words))
  await register(climber({ name: 'mapped', start: () => ({ seen: [{ of: new Map() }] }) }))
  assert.throws(() => new Session({ planner: 'mapped', scene: 'sphere-2' }), /state\.seen\[0\]\.of is a Map/)
})

test('without readings there is the best cost, where each candidate is a result', async () => {
  const { readings, ...none } = climber({ name: 'unread' })
  assert.ok(readings.length > 0)
  const described = await register(none)
  assert.deepEqual(
    described.readings.map(({ name }) => name),
    ['cost'],
  )
  const session = new Session({ planner: 'unread', scene: 'sphere-2', seed: 1 })
  session.step(10)
  assert.equal(session.readings().cost, session.outcome().cost)
  session.free()
})

test('the conformance suite says in words what is violated', async () => {
  const good = await conform(climber())
  assert.equal(String(good), 'hill-climber keeps to all 13 checks.')
  let calls = 0
  const start = (tools) => {
    calls += 1
    return { ...climber().start(tools), calls }
  }
  const advance = (_, tools) => climber().start(tools)
  const draw = (state) => {
    state.tried += 1
  }
  const wrongs = [
    [{ start }, 'the same seed is the same run', 'something else than `random`'],
    [{ draw }, 'looking changes nothing', 'changes the state'],
    [{ best: ({ cost, position }) => ({ cost: cost + 1, position }) }, 'it starts', 'the cost of its best is said to be'],
    [{ advance }, 'the best cost never rises', 'rises from'],
    [{ best: () => null }, 'a run has a result, and no fault', 'there is no best solution'],
    [{ readings: [{ name: 'ratio', value: () => Number.NaN }] }, 'readings are numbers', '`ratio` is no number'],
  ]
  for (const [more, check, words] of wrongs) {
    const { violations } = await conform(climber({ name: 'wrong', ...more }), { steps: 12 })
    const found = violations.find((violation) => violation.check === check)
    assert.ok(found?.found.includes(words), `${check}: ${JSON.stringify(violations.slice(0, 3))}`)
  }
})
