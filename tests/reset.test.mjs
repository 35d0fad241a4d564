// A module that broke down: no call reaches it, and `reset` gives a new one with the same parts.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { initSync } from '../pkg/glue.js'
import { catalogue, ModuleDead, reset, Session, Trial } from '../pkg/node.js'

const PAGE = 65536
const setup = { planner: 'pso', scene: 'wcpso-discs' }
const onGrid = { planner: 'aco', scene: catalogue().scenes.find(({ kind }) => kind === 'grid').name }

/** Takes all memory that there can be but a little, and asks for more. */
function breakDown() {
  const { memory } = initSync()
  memory.grow(65536 - memory.buffer.byteLength / PAGE)
  assert.throws(() => {
    for (;;) new Session({ planner: 'pso', scene: 'wcpso-discs', params: { population: 5000 } })
  }, dead)
}

const dead = (error) => {
  assert.ok(error instanceof ModuleDead && error instanceof Error)
  assert.equal(error.code, 'module-dead')
  assert.equal(
    error.message,
    `the module broke down (${error.cause}): no call works until \`reset()\` restarts it, without the sessions that it had`,
  )
  assert.ok(error.cause instanceof WebAssembly.RuntimeError)
  return true
}

const hashOf = (from) => {
  const session = new Session(from)
  session.step(20)
  const hash = session.hash()
  session.free()
  return hash
}

test('after a trap every call says so, and a reset brings all back but what was made before', () => {
  const before = [hashOf(setup), hashOf(onGrid)]
  for (let round = 0; round < 2; round++) {
    const session = new Session(onGrid)
    const trial = new Trial(setup)
    const freed = new Session(setup)
    freed.free()
    breakDown()
    for (const call of [() => session.step(1), () => trial.link(), () => new Session(setup), () => session.iteration])
      assert.throws(call, dead)
    // There is nothing to free any more, and to do it does not fail.
    freed.free()
    session.free()

    reset()
    const gone = { code: 'refused', field: 'Trial', message: /^Trial: one made before `reset\(\)` is not allowed/ }
    assert.throws(() => trial.step(1), gone)
    trial.free()
    trial.free()
    for (const old of [session, freed]) assert.throws(() => old.status, { code: 'refused', field: 'Session' })
    assert.deepEqual([hashOf(setup), hashOf(onGrid)], before)
    assert.throws(() => new Session({ ...setup, params: { population: -1 } }), { field: 'population', message: /^population: -1 is not/ })
  }
})

test('a reset of a module that works is a fresh start', () => {
  const session = new Session(setup)
  reset()
  assert.throws(() => session.step(1), { field: 'Session' })
  assert.equal(new Session(setup).iteration, 0)
})
