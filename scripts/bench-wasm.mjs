// Called by scripts/bench-wasm. Native time is the shell's own `elapsed_ms`: stepping only, as here.
import { spawnSync } from 'node:child_process'
import { parseArgs } from 'node:util'
import { catalogue, Session } from '../pkg/node.js'

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: { target: { type: 'string' }, against: { type: 'string' }, rounds: { type: 'string', default: '9' } },
})
const rounds = Number(values.rounds)
if (!(Number.isInteger(rounds) && rounds > 0)) throw new Error(`--rounds ${values.rounds}: a whole number greater than 0`)

/** What runs a setup: each returns its milliseconds and the hash of its end. */
const ways = { native: native(`${values.target}/release/forage`), wasm: wasm(Session) }
if (values.against) {
  ways['native before'] = native(`${values.against}/target/release/forage`)
  ways['wasm before'] = wasm((await import(`${values.against}/tree/pkg/node.js`)).Session)
}

function native(program) {
  return ({ planner, scene }) => {
    // A run that finds nothing has exit code 1 and its outcome all the same.
    const { status, stdout, stderr } = spawnSync(program, ['run', planner, '--scene', scene, '--json'], { maxBuffer: 1e9 })
    if (status > 1) throw new Error(String(stderr))
    const { elapsed_ms, hash } = JSON.parse(stdout)
    return { ms: elapsed_ms, hash }
  }
}

function wasm(Session) {
  return (setup) => {
    const session = new Session(setup)
    const begun = performance.now()
    session.step(1e6)
    const ms = performance.now() - begun
    const hash = session.hash()
    session.free()
    return { ms, hash }
  }
}

/** One setup for each kind of scene that a planner takes: of the scenes that ship, the one with the longest run. */
function setups({ name: planner, kinds }, scenes) {
  return kinds.flatMap((kind) => {
    const timed = scenes
      .filter((scene) => scene.kind === kind)
      .map(({ name: scene }) => ({ planner, scene, ms: length({ planner, scene }) }))
    const longest = Math.max(...timed.map(({ ms }) => ms))
    return timed.filter(({ ms }) => ms === longest && ms > 0).map(({ planner, scene }) => ({ planner, scene }))
  })
}

/** Milliseconds of a run; 0 if the planner refuses the scene, or waits for runs of others: that is not one thread's speed. */
function length(setup) {
  try {
    const session = new Session(setup)
    const alone = session.jobs().length === 0
    session.free()
    return alone ? ways.wasm(setup).ms : 0
  } catch {
    return 0
  }
}

/** Each way's fastest run of a setup. */
function measure(setup) {
  const fastest = {}
  for (let round = 0; round < rounds; round++) {
    const turns = Object.entries(ways)
    // The other way round each time: who goes first has a cold cache.
    for (const [name, run] of round % 2 ? turns.reverse() : turns) {
      const { ms, hash } = run(setup)
      fastest[name] ??= { ms, hash }
      if (hash !== fastest[name].hash) throw new Error(`${setup.planner} on ${setup.scene}: ${name} ended differently`)
      fastest[name].ms = Math.min(fastest[name].ms, ms)
    }
  }
  const { native, wasm } = fastest
  if (native.hash !== wasm.hash) throw new Error(`${setup.planner} on ${setup.scene}: native ${native.hash}, wasm ${wasm.hash}`)
  return fastest
}

const median = (numbers) => numbers.toSorted((a, b) => a - b)[Math.floor(numbers.length / 2)]
const pairs = [['wasm', 'native'], ...(values.against ? ['native', 'wasm'].map((way) => [way, `${way} before`]) : [])]
const heads = ['planner', 'scene', 'native ms', 'wasm ms', ...pairs.map(([a, b]) => `${a} / ${b}`)]
const widths = [18, 14, ...heads.slice(2).map((head) => head.length)]
const line = (cells) => console.log(cells.map((cell, i) => (i < 2 ? cell.padEnd(widths[i]) : cell.padStart(widths[i]))).join('  '))

const { planners, scenes } = catalogue()
for (const name of positionals) if (!planners.some((planner) => planner.name === name)) throw new Error(`there is no planner '${name}'`)
console.log(`Whole runs, the fastest of ${rounds}`)
line(heads)
const all = pairs.map(() => [])
for (const planner of planners.filter(({ name }) => positionals.length === 0 || positionals.includes(name)))
  for (const setup of setups(planner, scenes)) {
    const fastest = measure(setup)
    const ratios = pairs.map(([a, b]) => fastest[a].ms / fastest[b].ms)
    for (const [i, ratio] of ratios.entries()) all[i].push(ratio)
    const times = [fastest.native.ms, fastest.wasm.ms].map((ms) => ms.toFixed(2))
    line([setup.planner, setup.scene, ...times, ...ratios.map((ratio) => ratio.toFixed(3))])
  }
line(['median', '', '', '', ...all.map((ratios) => median(ratios).toFixed(3))])
