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

/** A program's run, on one thread. */
function native(program) {
  const env = { ...process.env, RAYON_NUM_THREADS: '1' }
  return ({ planner, scene }) => {
    // A run that finds nothing has exit code 1 and its outcome all the same.
    const { status, stdout, stderr } = spawnSync(program, ['run', planner, '--scene', scene, '--json'], { env, maxBuffer: 1e9 })
    if (status > 1) throw new Error(`${planner} on ${scene}: ${stderr}`)
    const { elapsed_ms, hash, parameters, cost, evaluations, iterations } = JSON.parse(stdout)
    return { ms: elapsed_ms, hash, same: JSON.stringify([parameters, cost, evaluations, iterations]) }
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

/** Every planner that was asked for, on every scene that ships and that it takes; and what it refuses. */
function setups({ planners, scenes }) {
  const setups = []
  const refused = []
  for (const { name: planner, kinds } of planners) {
    if (positionals.length > 0 && !positionals.includes(planner)) continue
    for (const { name: scene } of scenes.filter(({ kind }) => kinds.includes(kind))) {
      try {
        const session = new Session({ planner, scene })
        // Runs that wait for runs of others are the page's workers' in wasm: measured natively only.
        setups.push({ planner, scene, alone: session.jobs().length === 0 })
        session.free()
      } catch (error) {
        if (error.code !== 'refused') throw error
        refused.push({ planner, scene, field: error.field })
      }
    }
  }
  return { setups, refused }
}

/** Each way's fastest run of a setup; of runs that take seconds, three are enough. */
function measure(setup) {
  const fastest = {}
  for (let round = 0; round < (fastest.native?.ms > 1000 ? Math.min(rounds, 3) : rounds); round++) {
    const turns = Object.entries(ways).filter(([name]) => setup.alone || name.startsWith('native'))
    // The other way round each time: who goes first has a cold cache.
    for (const [name, run] of round % 2 ? turns.reverse() : turns) {
      const result = run(setup)
      fastest[name] ??= result
      if (result.hash !== fastest[name].hash) throw new Error(`${setup.planner} on ${setup.scene}: ${name} ended differently`)
      fastest[name].ms = Math.min(fastest[name].ms, result.ms)
    }
  }
  const { native, wasm } = fastest
  if (wasm && native.hash !== wasm.hash) throw new Error(`${setup.planner} on ${setup.scene}: native ${native.hash}, wasm ${wasm.hash}`)
  return fastest
}

const median = (numbers) => numbers.toSorted((a, b) => a - b)[Math.floor(numbers.length / 2)]
const pairs = [['wasm', 'native'], ...(values.against ? ['native', 'wasm'].map((way) => [way, `${way} before`]) : [])]
const heads = ['planner', 'scene', 'native ms', 'wasm ms', ...pairs.map(([a, b]) => `${a} / ${b}`)]
const widths = [18, 18, ...heads.slice(2).map((head) => head.length)]
const line = (cells) => console.log(cells.map((cell, i) => (i < 2 ? cell.padEnd(widths[i]) : cell.padStart(widths[i]))).join('  '))

const lists = catalogue()
for (const name of positionals)
  if (!lists.planners.some((planner) => planner.name === name)) throw new Error(`there is no planner '${name}'`)
console.log(`Whole runs, the fastest of ${rounds}`)
line(heads)
const all = pairs.map(() => [])
const { setups: runs, refused } = setups(lists)
const differ = []
for (const setup of runs) {
  const fastest = measure(setup)
  const before = fastest['native before']
  // With other defaults, or to another end, it is another run, not a faster or slower one.
  const other = before && before.same !== fastest.native.same
  const ratios = pairs.map(([a, b]) =>
    fastest[a] && fastest[b] && !(other && b.endsWith('before')) ? fastest[a].ms / fastest[b].ms : undefined,
  )
  for (const [i, ratio] of ratios.entries()) if (ratio !== undefined) all[i].push(ratio)
  if (other) differ.push(`${setup.planner} on ${setup.scene}`)
  const times = [fastest.native, fastest.wasm].map((run) => run?.ms.toFixed(2) ?? '–')
  line([setup.planner, setup.scene, ...times, ...ratios.map((ratio) => ratio?.toFixed(3) ?? '–')])
}
line(['median', '', '', '', ...all.map((ratios) => (ratios.length > 0 ? median(ratios).toFixed(3) : '–'))])
const waiting = runs.filter(({ alone }) => !alone).map(({ planner, scene }) => `${planner} on ${scene}`)
if (waiting.length > 0) console.log(`\nMeasured natively only, as they wait for runs of others: ${waiting.join(', ')}`)
if (differ.length > 0)
  console.log(
    `\nOther parameters, or another cost or number of evaluations or iterations than before, so not compared: ${differ.join(', ')}`,
  )
for (const field of new Set(refused.map(({ field }) => field))) {
  const those = refused.filter((refusal) => refusal.field === field)
  console.log(`\nRefused because of \`${field}\`: ${those.map(({ planner, scene }) => `${planner} on ${scene}`).join(', ')}`)
}
