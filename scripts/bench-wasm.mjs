// Called by scripts/bench-wasm. Native time is the shell's own `elapsed_ms`: stepping only, as here.
import { execFileSync } from 'node:child_process';
import { catalogue, Session } from '../pkg/node.js';

const rounds = Number(process.argv[2] ?? 9);
const iterations = 1000;
const functions = ['sphere', 'rosenbrock', 'ackley'];
const median = (numbers) => numbers.toSorted((a, b) => a - b)[Math.floor(numbers.length / 2)];

function native(planner, scene) {
  const args = ['run', planner, '--scene', scene, '--iterations', String(iterations), '--json'];
  return JSON.parse(execFileSync('target/release/forage', args));
}

function wasm(planner, scene) {
  const session = new Session({ planner, scene, params: { iterations } });
  const begun = performance.now();
  session.step(iterations);
  const elapsed = performance.now() - begun;
  const hash = session.hash();
  session.free();
  return { elapsed, hash };
}

console.log(`60 particles x ${iterations} iterations, D 10, median of ${rounds} (ms)`);
console.log('planner  function     native    wasm   ratio');
const ratios = [];
for (const { name } of catalogue().planners.filter((planner) => planner.family === 'swarm')) {
  for (const scene of functions) {
    wasm(name, scene); // warm: the first run compiles
    const times = { native: [], wasm: [] };
    for (let round = 0; round < rounds; round++) {
      const a = native(name, scene);
      const b = wasm(name, scene);
      if (a.hash !== b.hash) throw new Error(`${name} on ${scene}: native ${a.hash}, wasm ${b.hash}`);
      times.native.push(a.elapsed_ms);
      times.wasm.push(b.elapsed);
    }
    const [n, w] = [median(times.native), median(times.wasm)];
    ratios.push(w / n);
    console.log(`${name.padEnd(8)} ${scene.padEnd(11)} ${n.toFixed(2).padStart(7)} ${w.toFixed(2).padStart(7)} ${(w / n).toFixed(2).padStart(7)}`);
  }
}
console.log(`median ratio ${median(ratios).toFixed(2)}, target 1.3`);
