// The npm package as users get it: packed, installed into an empty project, imported in Node and type-checked.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('..', import.meta.url));
let project;

const run = (file, args, cwd = project) => execFileSync(file, args, { cwd, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });

before(() => {
  project = mkdtempSync(join(tmpdir(), 'forage-package-'));
  const [{ filename }] = JSON.parse(run('npm', ['pack', '--json', '--pack-destination', project], join(root, 'pkg')));
  writeFileSync(join(project, 'package.json'), JSON.stringify({ name: 'user', private: true, type: 'module' }));
  run('npm', ['install', '--no-audit', '--no-fund', '--offline', `./${filename}`]);
});

after(() => rmSync(project, { recursive: true, force: true }));

test('it holds one wasm file and nothing that users do not need', () => {
  const files = run('find', ['node_modules/forage', '-type', 'f']).trim().split('\n');
  assert.equal(files.filter((file) => file.endsWith('.wasm')).length, 1);
  assert.ok(files.length <= 8, files.join('\n'));
});

test('an empty Node project imports it, with and without init', () => {
  writeFileSync(
    join(project, 'run.js'),
    `import init, { catalogue, Session } from 'forage';
     await init();
     const session = new Session({ planner: 'wcpso', scene: 'wcpso-discs', seed: 1 });
     while (session.status === 'running') session.step(100);
     const { feasible, gap, hash } = session.outcome();
     console.log(JSON.stringify({ feasible, gap, hash, planners: catalogue().planners.length }));
     session.free();`,
  );
  const outcome = JSON.parse(run('node', ['run.js']));
  assert.equal(outcome.feasible, true);
  assert.ok(outcome.gap < 0.005);
  assert.ok(outcome.planners >= 4);
});

test('its types are exact', () => {
  writeFileSync(
    join(project, 'types.ts'),
    `import { Session, type Outcome, type Status } from 'forage';
     const session = new Session({ planner: 'pso', scene: 'sphere', params: { w: 0.7 }, seed: 2 });
     const status: Status = session.step(3);
     const outcome: Outcome = session.outcome();
     const cost: number | null = outcome.cost;
     // @ts-expect-error a seed is a number
     new Session({ planner: 'pso', scene: 'sphere', seed: 'one' });
     // @ts-expect-error there is no such member
     session.fly();
     export { status, cost };`,
  );
  const compiler = join(root, 'www/node_modules/typescript/bin/tsc');
  run('node', [compiler, '--noEmit', '--strict', '--target', 'es2022', '--module', 'nodenext', '--moduleResolution', 'nodenext', '--lib', 'esnext,dom', 'types.ts']);
});

test('a page can import it from plain files', () => {
  const glue = readFileSync(join(project, 'node_modules/forage/forage.js'), 'utf8');
  assert.match(glue, /new URL\('forage_bg\.wasm', import\.meta\.url\)/);
  const { exports } = JSON.parse(readFileSync(join(project, 'node_modules/forage/package.json'), 'utf8'));
  assert.deepEqual(Object.keys(exports['.']), ['node', 'types', 'default']);
});
