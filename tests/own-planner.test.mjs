// `examples/own-planner` is used as its author would: a crate outside, one file, whose `main` is the whole shell.
// OWN_PLANNER is the program; without it, what `cargo test` builds as an example.
import assert from 'node:assert/strict'
import { spawnSync } from 'node:child_process'
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { test } from 'node:test'

const ROOT = join(import.meta.dirname, '..')
const TARGET = process.env.CARGO_TARGET_DIR ?? join(ROOT, 'target')
const PROGRAM = process.env.OWN_PLANNER ?? join(TARGET, 'debug/examples/own-planner')
const folder = mkdtempSync(join(tmpdir(), 'own-planner-'))

const shell = (...args) => spawnSync(PROGRAM, args, { cwd: folder, encoding: 'utf8', maxBuffer: 1 << 28 })

function forage(...args) {
  const run = shell(...args)
  assert.equal(run.status, 0, run.error?.message ?? run.stderr)
  return run.stdout
}

test('it lists our planners and its own, its scene, and its layer with its look', () => {
  const { planners, scenes, roles } = JSON.parse(forage('list', '--json'))
  const named = (name) => planners.find((planner) => planner.name === name)
  assert.ok(named('wcpso') && named('compass-search') && named('wcpso-himmelblau'))
  assert.ok(scenes.some((scene) => scene.kind === 'himmelblau') && roles.includes('stencil'))
  const stencil = named('compass-search').layers.find((layer) => layer.role === 'stencil')
  assert.deepEqual([stencil.look.color, stencil.look.glyph], [{ light: '#8a3ffc', dark: '#be95ff' }, 'diamond'])
  assert.match(forage('list', 'compass-search'), /contraction +a number from 0\.1 to 0\.9/)
})

test('it runs, and draws its layer', () => {
  const svg = join(folder, 'run.svg')
  const outcome = JSON.parse(forage('run', 'compass-search', '--scene', 'himmelblau', '--iterations', '30', '--svg', svg, '--json'))
  assert.ok(outcome.feasible && outcome.exact === 0 && outcome.cost < 1e-2, JSON.stringify(outcome))
  const picture = readFileSync(svg, 'utf8')
  assert.match(picture, /<path class="stencil" d="M[^"]*Z" stroke="#8a3ffc"/, 'a diamond')
  assert.match(picture, /<rect x="24" y="24" width="852" height="852" stroke=/, 'the border of the scene')
  const swarm = JSON.parse(forage('run', 'wcpso-himmelblau', '--scene', 'himmelblau', '--json'))
  assert.ok(swarm.cost < 1e-9)
})

test('what is refused is refused as for ours', () => {
  const run = shell('run', 'compass-search', '--scene', 'himmelblau', '--set', 'step=2')
  assert.equal(run.status, 2)
  assert.match(run.stderr, /step.*2.*0\.001 to 0\.5/)
})

test('an experiment compares them', () => {
  const file = join(folder, 'sweep.toml')
  const planners = ['compass-search', 'wcpso-himmelblau'].map((name) => `[[planner]]\nname = "${name}"\n`).join('')
  writeFileSync(file, `scenes = ["himmelblau"]\nseeds = { from = 1, count = 4 }\n${planners}`)
  const { groups } = JSON.parse(forage('experiment', file, '--json')).scenes[0]
  assert.match(readFileSync(join(folder, 'sweep.csv'), 'utf8'), /compass-search.*\n(.*\n)*.*wcpso-himmelblau/)
  assert.equal(groups.length, 2)
})
