// The templates for planners of one's own: each keeps to the contract, and the swarm is the published one.
import assert from 'node:assert/strict'
import { readdirSync, readFileSync } from 'node:fs'
import { test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { codeIn, registerCode, withCode } from '../pkg/isolate.node.js'
import { register, Session } from '../pkg/node.js'
import { conform } from '../pkg/testing.node.js'
import { saidAt, tagsOf, textsOf } from '../scripts/languages/folder.mjs'
import { translated, wordsOf } from '../scripts/languages/templates.mjs'

const FOLDER = new URL('../templates/', import.meta.url)
const templates = Object.fromEntries(
  readdirSync(FOLDER).map((file) => [file.replace('.js', ''), readFileSync(new URL(file, FOLDER), 'utf8')]),
)

/** What a template registers, in this thread. */
function plannerOf(code) {
  let given
  const own = (planner) => {
    given = planner
  }
  new Function('register', code.replace(/^import .*$/m, ''))(own)
  return given
}

for (const [name, code] of Object.entries(templates)) {
  test(`${name} keeps to the contract, and is the same in the interpreter`, async () => {
    const planner = plannerOf(code)
    const scenes = planner.kinds[0] === 'tour' ? ['open-12', 'random-52'] : undefined
    const report = await conform(planner, { steps: 15, scenes })
    assert.deepEqual(report.violations, [])
    const { kinds } = await register(planner)
    const scene = { function: 'rastrigin', tour: 'random-52', discs: 'discs-gate' }[kinds[0]]
    const run = () => {
      const session = new Session({ planner: planner.name, scene, seed: 3 })
      session.step(20)
      const { hash, cost } = session.outcome()
      return { hash, cost, readings: session.readings() }
    }
    const here = run()
    await registerCode(code)
    assert.deepEqual(run(), here)
  })
}

test('every template has the hash that it has natively, and mathematics of all kinds', async () => {
  const stored = JSON.parse(readFileSync(new URL('../crates/isolate/tests/hashes.json', import.meta.url), 'utf8'))
  for (const name of Object.keys(templates)) assert.ok(stored.some(([file]) => file === `templates/${name}.js`))
  for (const [name, scene, seed, hash] of stored) {
    const code = readFileSync(new URL(`../${name}`, import.meta.url), 'utf8')
    const session = new Session({ planner: (await registerCode(code)).name, scene, seed })
    session.step(20)
    assert.equal(session.hash(), hash, name)
  }
})

const LOCALES = fileURLToPath(new URL('../locales', import.meta.url))
for (const tag of tagsOf(LOCALES)) {
  const texts = textsOf(`${LOCALES}/${tag}`)
  for (const [name, code] of Object.entries(templates)) {
    test(`${name} is the same planner in ${tag}`, async () => {
      const own = translated(code, (words) => saidAt(texts[words], `templates.${name}`))
      for (const words of wordsOf(code)) assert.ok(texts[words], words)
      // But for what it says it is the same, and so are its values in sentences.
      const bare = (text) => [translated(text, () => '…'), wordsOf(text).map((words) => words.match(/\$\{.*?\}/g))]
      assert.deepEqual(bare(own), bare(code))
      const ends = []
      for (const one of [own, code]) {
        const scene = { function: 'rastrigin', tour: 'random-52', discs: 'discs-gate' }[plannerOf(one).kinds[0]]
        const session = new Session({ planner: (await registerCode(one)).name, scene, seed: 3 })
        session.step(20)
        ends.push(session.hash())
        session.free()
      }
      assert.equal(ends[0], ends[1])
    })
  }
}

test('code travels in links', async () => {
  const session = new Session({ planner: (await registerCode(templates.rrt)).name, scene: 'discs-gate', seed: 3 })
  session.step(20)
  const link = await withCode(session.link(), templates.rrt)
  assert.equal(await codeIn(link), templates.rrt)
  assert.ok(link.length < 3000, `${link.length} characters`)
  const opened = Session.fromLink(link)
  opened.seek(20)
  assert.equal(opened.hash(), session.hash())
  const again = await withCode(link, 'register({})')
  assert.equal(await codeIn(again), 'register({})')
  assert.equal(await codeIn(session.link()), undefined)
  const noise = Array.from({ length: 20000 }, () => String.fromCharCode(33 + Math.floor(90 * Math.random()))).join('')
  await assert.rejects(withCode(link, noise), /at most 8192 bytes/)
  for (const damaged of ['!', 'AAAA', 'A'.repeat(20000)]) await assert.rejects(codeIn(`#v=1&page.code=${damaged}`), { field: 'code' })
})

test('the tree comes to the goal, and the path is free', async () => {
  await register(plannerOf(templates.rrt))
  for (const scene of ['discs-gate', 'qpso-10m', 'rooms-20']) {
    const session = new Session({ planner: 'my-rrt', scene, seed: 1, params: { iterations: 20000 } })
    session.step(20000)
    const { feasible, status, length, cost } = session.outcome()
    assert.deepEqual([feasible, status, cost], [true, 'exhausted', length], scene)
  }
})

test('the swarm gives the bits of `pso`, for 1,000 iterations on three functions', async () => {
  const mine = await register(plannerOf(templates.pso))
  for (const scene of ['sphere', 'rosenbrock', 'rastrigin']) {
    const [published, own] = ['pso', mine.name].map((planner) => new Session({ planner, scene, seed: 11 }))
    for (let k = 0; k <= 1000; k += 1) {
      const [a, b] = [published.outcome(), own.outcome()]
      assert.deepEqual([b.cost, b.position, b.evaluations], [a.cost, a.position, a.evaluations], `${scene}, iteration ${k}`)
      published.step(1)
      own.step(1)
    }
    assert.ok(published.iteration === 1000 && own.iteration === 1000)
  }
})
