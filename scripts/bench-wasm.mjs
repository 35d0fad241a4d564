// Called by scripts/bench-wasm. Native time is the shell's own `elapsed_ms`: stepping only, as here.
import { spawnSync } from 'node:child_process'
import { catalogue, Session } from '../pkg/node.js'

const rounds = Number(process.argv[2] ?? 9)
const iterations = 1000
const functions = ['sphere', 'rosenbrock', 'ackley']
const median = (numbers) => numbers.toSorted((a, b) => a - b)[Math.floor(numbers.length / 2)]

function native(planner, scene, steps = iterations) {
  const args = ['run', planner, '--scene', scene, '--iterations', String(steps), '--json']
  // A run that finds nothing has exit code 1 and its outcome all the same.
  return JSON.parse(spawnSync('target/release/forage', args, { maxBuffer: 1e8 }).stdout)
}

function wasm(planner, scene, steps = iterations) {
  const session = new Session({ planner, scene, params: { iterations: steps } })
  const begun = performance.now()
  session.step(steps)
  const elapsed = performance.now() - begun
  const hash = session.hash()
  session.free()
  return { elapsed, hash }
}

console.log(`60 particles x ${iterations} iterations, D 10, median of ${rounds} (ms)`)
console.log('planner  function     native    wasm   ratio')
const ratios = []

function compare(name, scene, steps) {
  wasm(name, scene, steps) // warm: the first run compiles
  const times = { native: [], wasm: [] }
  for (let round = 0; round < rounds; round++) {
    const a = native(name, scene, steps)
    const b = wasm(name, scene, steps)
    if (a.hash !== b.hash) throw new Error(`${name} on ${scene}: native ${a.hash}, wasm ${b.hash}`)
    times.native.push(a.elapsed_ms)
    times.wasm.push(b.elapsed)
  }
  const [n, w] = [median(times.native), median(times.wasm)]
  console.log(
    `${name.padEnd(8)} ${scene.padEnd(11)} ${n.toFixed(2).padStart(7)} ${w.toFixed(2).padStart(7)} ${(w / n).toFixed(2).padStart(7)}`,
  )
  return w / n
}

for (const { name } of catalogue().planners.filter((planner) => planner.family === 'swarm')) {
  for (const scene of functions) ratios.push(compare(name, scene))
}
console.log(`median ratio ${median(ratios).toFixed(2)}, target 1.3`)
console.log('trees, 5000 extensions at most (ms)')
for (const name of ['rrt', 'rrt-star']) compare(name, 'arm-cuboid', 5000)
