// The npm package as users get it: packed, installed into an empty project, imported in Node, type-checked, and opened in a page.
import assert from 'node:assert/strict'
import { execFileSync, spawnSync } from 'node:child_process'
import { cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { after, before, test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { catalogue, Session } from '../pkg/node.js'
import { look, serve } from './support/static.mjs'
import { tagsOf } from '../scripts/languages/folder.mjs'

const root = fileURLToPath(new URL('..', import.meta.url))
// scripts/test builds it, and says where.
const shell = process.env.FORAGE ?? join(root, 'target/debug', process.platform === 'win32' ? 'forage.exe' : 'forage')
let project, tarball

/** The block of the book's chapter on JavaScript in a language that holds some text. */
const example = (language, text) => {
  const [, ...blocks] = readFileSync(join(root, 'docs/javascript.md'), 'utf8').split(`\`\`\`${language}\n`)
  const found = blocks.map((block) => block.slice(0, block.indexOf('```'))).filter((block) => block.includes(text))
  assert.equal(found.length, 1, `${found.length} blocks of ${language} with ${text}`)
  return found[0]
}

/** What the shell prints of a run. */
const inShell = ({ planner, scene, seed, params = {} }) => {
  const set = Object.entries(params).flatMap(([name, value]) => ['--set', `${name}=${value}`])
  return JSON.parse(run(shell, ['run', planner, '--scene', scene, '--seed', String(seed), ...set, '--json']))
}

const run = (file, args, cwd = project) => execFileSync(file, args, { cwd, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] })

before(() => {
  project = mkdtempSync(join(tmpdir(), 'forage-package-'))
  const [{ filename }] = JSON.parse(run('npm', ['pack', '--json', '--pack-destination', project], join(root, 'pkg')))
  writeFileSync(join(project, 'package.json'), JSON.stringify({ name: 'user', private: true, type: 'module' }))
  run('npm', ['install', '--no-audit', '--no-fund', '--offline', `./${filename}`])
  tarball = join(project, filename)
  assert.ok(existsSync(shell), 'call `scripts/test package`, or build the command line with `cargo build`')
})

after(() => rmSync(project, { recursive: true, force: true }))

test('it holds the parts of the module and nothing that users do not need', () => {
  const all = run('find', ['node_modules/forage-lab', '-type', 'f']).trim().split('\n')
  const files = all.filter((file) => !file.startsWith('node_modules/forage-lab/render/'))
  const parts = files.filter((file) => file.endsWith('.wasm') && !file.endsWith('interpreter.wasm')).length
  assert.ok(parts > 5)
  // Of each part its code, its words and two entries; then the loader, sessions in threads, types, words, the catalogue, notices,
  // licences and what it holds of others, and for pages the element, what speaks with an embedded run and the renderer, with their types. For planners of one's own what registers and tests them, the
  // interpreter and its types; and the shipped scenes of four parts. Each other language has words of each part, all of them, and those of the catalogue.
  assert.ok(all.length > files.length)
  const languages = files.filter((file) => /locales\/[^/]+\.json$/.test(file)).length
  assert.equal(languages, tagsOf(fileURLToPath(new URL('../locales', import.meta.url))).length + 1)
  assert.ok(files.length <= 4 * parts + 49 + (languages - 1) * (parts + 2), files.join('\n'))
  for (const file of ['README.md', 'LICENSE-MIT', 'LICENSE-APACHE', 'THIRD-PARTY.md', 'sbom.cdx.json'])
    assert.ok(files.includes(`node_modules/forage-lab/${file}`), file)
})

test('it lists what it holds of others', () => {
  const { bomFormat, components } = JSON.parse(readFileSync(join(project, 'node_modules/forage-lab/sbom.cdx.json'), 'utf8'))
  assert.equal(bomFormat, 'CycloneDX')
  const listed = new Set(components.map(({ purl }) => purl))
  assert.equal(listed.size, components.length)
  // Those that are compiled into the wasm, by cargo itself.
  const of = ['tree', '--locked', '--edges', 'normal,no-proc-macro', '--package', 'forage-lab-module', '--target', 'wasm32-unknown-unknown']
  const crates = run('cargo', [...of, '--prefix', 'none', '--format', '{p}'], root)
    .split('\n')
    .flatMap((line) => (/^forage-lab|^$/.test(line) ? [] : [line.replace(/ \(.*/, '').replace(' v', '@')]))
  assert.ok(crates.length > 30)
  for (const crate of crates) assert.ok(listed.has(`pkg:cargo/${crate}`), crate)
  for (const name of ['%40fluent/bundle', 'comlink', 'quickjs-emscripten-core'])
    assert.ok(
      [...listed].some((purl) => purl.startsWith(`pkg:npm/${name}@`)),
      name,
    )
  for (const { purl, hashes, licenses } of components) assert.ok(hashes?.length && licenses?.length, purl)
})

test('an empty Node project imports it, with and without init', () => {
  writeFileSync(
    join(project, 'run.js'),
    `import init, { catalogue, Session } from 'forage-lab';
     await init();
     const session = new Session({ planner: 'wcpso', scene: 'wcpso-discs', seed: 1 });
     while (session.status === 'running') session.step(100);
     const { feasible, gap, hash } = session.outcome();
     console.log(JSON.stringify({ feasible, gap, hash, planners: catalogue().planners.length }));
     session.free();`,
  )
  const outcome = JSON.parse(run('node', ['run.js']))
  assert.equal(outcome.feasible, true)
  assert.ok(outcome.gap < 0.005)
  assert.ok(outcome.planners >= 4)
})

test('every part has an entry: ready in Node, with its words, catalogue and types', () => {
  const setups = {
    swarm: { planner: 'wcpso', scene: 'wcpso-discs', seed: 1, params: { iterations: 60 } },
    grid: { planner: 'aco-wolf', scene: 'ant-bat-30', seed: 1, params: { iterations: 5 } },
    tour: { planner: 'sa', scene: 'random-52', seed: 1 },
    arm: { planner: 'rrt-guided', scene: 'arm-bench', seed: 1 },
  }
  for (const [part, setup] of Object.entries(setups)) {
    writeFileSync(
      join(project, 'part.js'),
      `import { Session } from 'forage-lab/${part}';
       import catalogue from 'forage-lab/catalogue.json' with { type: 'json' };
       const session = new Session(${JSON.stringify(setup)});
       while (session.status === 'running') session.step(100);
       let refused;
       try { new Session({ ...${JSON.stringify(setup)}, seed: -1 }) } catch ({ message }) { refused = message }
       console.log(JSON.stringify({ hash: session.hash(), refused, planners: catalogue.planners.length }));`,
    )
    const { hash, refused, planners } = JSON.parse(run('node', ['part.js']))
    assert.equal(hash, inShell(setup).hash, part)
    assert.match(refused, /^seed: -1 is not allowed; it must be a whole number from 0 to /)
    assert.ok(planners > 20)
  }
})

const BATCH = {
  planners: ['pso', 'wcpso', 'qpso', 'ltqpso'],
  scenes: ['wcpso-discs', 'sphere'],
  seeds: [1, 2, 3, 4, 5],
  params: { iterations: 60, population: 30 },
}

test('a batch in an empty project has the shell’s rows, and statistics', () => {
  writeFileSync(
    join(project, 'batch.js'),
    `import { compare, Trial } from 'forage-lab';
     const { planners, scenes, seeds, params } = ${JSON.stringify(BATCH)};
     const rows = [];
     for (const scene of scenes)
       for (const planner of planners)
         for (const seed of seeds) {
           const trial = new Trial({ planner, scene, params, seed });
           while (trial.step(7) === 'running');
           rows.push({ ...trial.record(), last: trial.curve().values.at(-1) ?? null, at: trial.iteration, link: trial.link() });
           trial.free();
         }
     const compared = scenes.map((scene) =>
       compare(planners.map((name) => ({ name, values: rows.filter((row) => row.scene === scene && row.planner === name).map((row) => row.value) }))));
     console.log(JSON.stringify({ rows, compared }));`,
  )
  const { rows, compared } = JSON.parse(run('node', ['batch.js']))
  const { planners, scenes, seeds, params } = BATCH
  assert.equal(rows.length, planners.length * scenes.length * seeds.length)
  for (const row of rows) {
    const { planner, scene, seed } = row
    const told = inShell({ planner, scene, seed, params })
    const value = told.feasible ? (told.length ?? told.cost) : null
    const [mine, theirs] = [row, { ...told, value }].map(({ hash, value, evaluations, iterations, status, feasible, gap }) => ({
      hash,
      value,
      evaluations,
      iterations,
      status,
      feasible,
      gap,
    }))
    assert.deepEqual(mine, theirs, `${planner} on ${scene}, seed ${seed}`)
    assert.deepEqual([row.last, row.at, row.parameters], [value, told.iterations, params])
    assert.ok(row.link.includes(`hash=${row.hash}`))
  }
  for (const [k, { groups, pairs, friedman }] of compared.entries()) {
    assert.deepEqual(
      groups.map(({ name, runs }) => [name, runs]),
      planners.map((name) => [name, seeds.length]),
    )
    for (const { name, feasible, rate, summary } of groups) {
      const values = rows.filter((row) => row.scene === scenes[k] && row.planner === name && row.value !== null).map(({ value }) => value)
      assert.deepEqual(
        [feasible, rate, summary?.min ?? null, summary?.max ?? null],
        [values.length, values.length / seeds.length, ...(values.length ? [Math.min(...values), Math.max(...values)] : [null, null])],
      )
      if (summary)
        assert.ok(Math.abs(summary.mean - values.reduce((sum, value) => sum + value, 0) / values.length) <= 1e-12 * Math.abs(summary.mean))
    }
    assert.equal(pairs.length, (planners.length * (planners.length - 1)) / 2)
    assert.ok(pairs.every(({ p, corrected }) => p > 0 && p <= corrected && corrected <= 1))
    assert.equal(friedman.blocks, seeds.length)
    assert.ok(Math.abs(friedman.ranks.reduce((sum, rank) => sum + rank, 0) - 10) < 1e-9)
  }
})

test('what is refused is an error with field, value and what is allowed', () => {
  writeFileSync(
    join(project, 'refused.js'),
    `import { compare, Trial } from 'forage-lab';
     const tries = [
       () => new Trial({ planner: 'pso', scene: 'sphere', params: { population: 0 }, seed: 1 }),
       () => new Trial({ planner: 'pso', scene: 'nowhere', seed: 1 }),
       () => new Trial({ planner: 'pso', scene: 'sphere', seed: 1 }, -1),
       () => compare([{ name: 'pso' }]),
     ];
     console.log(JSON.stringify(tries.map((make) => {
       try { make(); return 'accepted'; } catch (error) { return { error: error instanceof Error, field: error.field, value: error.value, message: error.message }; }
     })));`,
  )
  const refused = JSON.parse(run('node', ['refused.js']))
  assert.deepEqual(
    refused.map(({ error, field }) => [error, field]),
    [
      [true, 'population'],
      [true, 'scene'],
      [true, 'within'],
      [true, 'groups[0].values'],
    ],
  )
  for (const { message } of refused) assert.ok(message.length > 10, message)
})

test('the book’s batch runs as it stands, and says what the shell’s runs say', () => {
  writeFileSync(join(project, 'example.js'), example('js', 'new Trial('))
  const lines = run('node', ['example.js']).trim().split('\n')
  const [first] = lines
  const { value, evaluations, hash } = JSON.parse(first)
  const told = inShell({ planner: 'pso', scene: 'wcpso-discs', seed: 1, params: { iterations: 100 } })
  assert.deepEqual({ value, evaluations, hash }, { value: told.length, evaluations: told.evaluations, hash: told.hash })
  for (const planner of ['pso', 'wpso', 'wcpso'])
    assert.ok(
      lines.some((line) => line.startsWith(`${planner}: `)),
      lines.join('\n'),
    )
})

test('its types are exact', () => {
  writeFileSync(
    join(project, 'types.ts'),
    `import init, { catalogue, compare, load, parseLink, ready, Session, Trial, type Comparison, type Group, type LayerName, type Outcome, type Setup, type Status, type TrialCurve, type TrialRecord, type UncheckedSetup } from 'forage-lab';
     import { WorkerSession } from 'forage-lab/worker';
     const session = new Session({ planner: 'pso', scene: 'sphere', params: { w: 0.7 }, seed: 2 });
     const status: Status = session.step(3);
     const outcome: Outcome = session.outcome();
     const cost: number | null = outcome.cost;
     const trial = new Trial({ planner: 'pso', scene: 'sphere', seed: 2 });
     new Trial({ planner: 'pso', scene: 'sphere' }, 0.02).free();
     trial.step();
     const record: TrialRecord = trial.record();
     const curve: TrialCurve = trial.curve();
     const evaluations: Float64Array = curve.evaluations;
     const group: Group = { name: record.planner, values: [record.value, null] };
     const comparison: Comparison = compare([group, group]);
     const mean: number | undefined = comparison.groups[0]?.summary?.mean;
     const p: number | null | undefined = comparison.friedman?.p;
     const image: { readonly width: number } | undefined = session.layerImage('best', ['#000000', '#ffffff80'])?.image;
     const drawn: LayerName | undefined = session.frame().layers[0];
     await init();
     const other: Session = await ready(() => new Session({ planner: 'rrt', scene: 'arm-bench' }));
     other[Symbol.dispose]();
     // What the package gives it takes, names that are known only at run time too.
     new Session(parseLink(session.link())).free();
     for (const job of other.jobs()) new Session({ ...job, scene: other.scene }).free();
     for (const { name } of catalogue().planners) new Session({ planner: name, scene: 'sphere', seed: 1 });
     const typed: UncheckedSetup = { planner: 'pso', scene: 'sphere', params: { [String(status)]: 1 } };
     new Session(typed as Setup);
     // @ts-expect-error there is no such part
     await load('birds');
     // @ts-expect-error there is no such planner
     new Session({ planner: 'psso', scene: 'sphere' });
     // @ts-expect-error there is no such scene
     new Session({ planner: 'pso', scene: 'cube' });
     // @ts-expect-error it is a parameter of another planner
     new Session({ planner: 'pso', scene: 'sphere', params: { alpha_start: 1 } });
     // @ts-expect-error an encoding is one of two
     new Session({ planner: 'pso', scene: 'wcpso-discs', params: { encoding: 'spherical' } });
     // @ts-expect-error there is no such layer
     session.layerImage('beest');
     // @ts-expect-error a seed is a number
     new Session({ planner: 'pso', scene: 'sphere', seed: 'one' });
     // @ts-expect-error there is no such member
     session.fly();
     // @ts-expect-error a value is a number, or null
     compare([{ name: 'pso', values: ['1'] }]);
     // @ts-expect-error a record has no times
     record.elapsed_ms;
     const remote: WorkerSession = await WorkerSession.start({ planner: 'pso', scene: 'sphere' });
     const later: number = await remote.iteration;
     const whole: Outcome = await remote.outcome();
     remote[Symbol.dispose]();
     // @ts-expect-error what it returns is a promise
     const now: number = remote.iteration;
     // @ts-expect-error there is no such planner
     await WorkerSession.start({ planner: 'psso', scene: 'sphere' });
     export { status, cost, drawn, later, now, whole, evaluations, image, mean, p };`,
  )
  // Its own types are checked as well, with the language's library alone and with all that there is.
  for (const lib of ['es2022', 'esnext,dom']) typed('types.ts', lib)
})

const typed = (file, lib = 'es2022') => {
  const options = ['--noEmit', '--strict', '--target', 'es2022', '--module', 'nodenext', '--moduleResolution', 'nodenext', '--lib', lib]
  const told = spawnSync('node', [join(root, 'www/node_modules/typescript/bin/tsc'), ...options, file], { cwd: project, encoding: 'utf8' })
  assert.equal(told.status, 0, told.stdout)
}

test('its types are those of what it gives: nothing is missing, nothing is left out', () => {
  // Their source goes into the script below, which has what they call.
  const made = {
    Catalogue: () => [catalogue()],
    Outcome: () => Object.values(runs).map((session) => session.outcome()),
    Stage: () => Object.values(runs).flatMap((session) => session.stages),
    Inspection: () => Object.values(runs).flatMap(told),
    Exact: () =>
      Object.values(runs)
        .map((session) => session.exact())
        .filter(Boolean),
    LinkSetup: () => Object.values(runs).map((session) => parseLink(session.link())),
    Suggestion: () => [suggest({ planner: 'ltqpso', scene: 'qpso-10m' })].filter(Boolean),
    Job: () => jobs.jobs(),
    TrialRecord: () =>
      Object.values(setups)
        .map((setup) => new Trial(setup))
        .map((trial) => {
          trial.step(9)
          return trial.record()
        }),
    Comparison: () => [compare(['a', 'b', 'c'].map((name, k) => ({ name, values: [1 + k, 2, null, 4 - k] })))],
    Imported: () => [importScene(exportScene(runs.grid.scene, 'movingai')), importScene(exportScene(runs.tour.scene, 'csv'))],
    ArmPose: () => [armPose('arm-bench', [0, 0, 0, 0, 0, 0])],
    ArmSolutions: () => [armSolutions('arm-bench', [0.5, 0.2, 0.5], null), armSolutions('arm-bench', [9, 9, 9], null)],
  }
  const setups = {
    function: { planner: 'cuckoo-search', scene: 'sphere' },
    discs: { planner: 'wcpso', scene: 'wcpso-discs' },
    grid: { planner: 'aco-wolf', scene: 'ant-bat-30', params: { iterations: 5 } },
    drive: { planner: 'ltqpso', scene: 'qpso-10m', params: { iterations: 200 } },
    tour: { planner: 'sa', scene: 'random-52', params: { iterations: 20 } },
    trees: { planner: 'rrt-guided', scene: 'arm-bench' },
    postures: { planner: 'rrt-joint', scene: 'arm-bench' },
    moving: { planner: 'wolf-ant-drive', scene: 'crossing', params: { iterations: 150 } },
    tuning: { planner: 'pso-tuning', scene: 'wolf-ant-20', params: { population: 2, iterations: 1, seeds: 1, colony_iterations: 1 } },
  }
  writeFileSync(
    join(project, 'values.js'),
    `import { armPose, armSolutions, catalogue, compare, exportScene, importScene, parseLink, Session, suggest, Trial } from 'forage-lab';
     const setups = ${JSON.stringify(setups)};
     const runs = Object.fromEntries(Object.entries(setups).map(([name, setup]) => {
       const session = new Session(setup);
       session.step(Infinity);
       return [name, session];
     }));
     const jobs = new Session(setups.tuning);
     const told = (session) => {
       const { planners } = catalogue();
       const { layers } = planners.find(({ name }) => name === session.planner);
       return layers.filter(({ pickable }) => pickable).map(({ role }) => session.inspect({ role, index: 0 })).filter(Boolean);
     };
     const made = { ${Object.entries(made)
       .map(([name, make]) => `${name}: ${make}`)
       .join(', ')} };
     const values = Object.entries(made).map(([name, make]) => [name, make()]);
     for (const [name, list] of values) if (!list.length) throw new Error('nothing is made of ' + name);
     // As source code: JSON has no NaN, which readings may be.
     const code = (value) => JSON.stringify(value, (_, inner) => (Number.isNaN(inner) ? '@NaN' : inner)).replaceAll('"@NaN"', 'NaN');
     console.log("import type { " + Object.keys(made).join(', ') + " } from 'forage-lab';");
     for (const [name, list] of values)
       for (const [k, value] of list.entries()) console.log('export const ' + name + k + ' = ' + code(value) + ' satisfies ' + name + ';');`,
  )
  writeFileSync(join(project, 'values.ts'), run('node', ['values.js']))
  typed('values.ts')
})

test('it can be published, and those who check packages find nothing', () => {
  const tool = (name) => join(root, 'www/node_modules/.bin', name)
  assert.match(run(tool('publint'), ['--strict', tarball]), /All good!/)
  // It has no entry for `require`: of that there is something to find.
  run(tool('attw'), [tarball, '--profile', 'esm-only'])
  assert.throws(() => run(tool('attw'), [tarball]))
  run('npm', ['publish', '--dry-run', '--offline', tarball])
})

test('a page and Node have an entry each', () => {
  const { exports } = JSON.parse(readFileSync(join(project, 'node_modules/forage-lab/package.json'), 'utf8'))
  assert.deepEqual(exports['.'], { types: './forage.d.ts', node: './node.js', default: './forage.js' })
})

const SETUP = { planner: 'wcpso', scene: 'wcpso-discs', seed: 7, params: { iterations: 40 } }
/** A link that carries an arm of its own. */
function armLink() {
  const arm = catalogue().scenes.find(({ kind }) => kind === 'arm')
  const session = new Session({ planner: 'rrt', scene: { ...arm, name: 'own', title: 'Own' } })
  const link = session.link()
  session.free()
  return link
}

/** A page that runs a session, and says what came of it; before that, one that needs another part. */
const script = (from, worker) => `
  import init, { parseLink, ready, Session } from '${from}';
  import { WorkerSession } from '${worker}';
  await init();
  let refused;
  try { new Session({ planner: 'a-star', scene: 'ant-bat-30' }) } catch ({ code, message }) { refused = code + message }
  if (!refused.startsWith('not-loaded') || !refused.includes("load('grid')")) throw new Error(refused);
  const other = await ready(() => new Session({ planner: 'a-star', scene: 'ant-bat-30' }));
  other.step(Infinity);
  if (!other.outcome().feasible) throw new Error('no path');
  other.free();
  const opened = await ready(() => parseLink('${armLink()}'));
  if (opened.scene.kind !== 'arm') throw new Error(opened.scene.kind);
  const there = await WorkerSession.start({ planner: 'a-star', scene: 'ant-bat-30' });
  await there.step(Infinity);
  const { vertices, layers } = await there.frame();
  if (vertices.buffer.byteLength !== vertices.byteLength || !layers.includes('best')) throw new Error('a frame that is no copy');
  const image = await there.layerImage('closed', ['#000000', '#ffffff']);
  if (!(image.image instanceof ImageData)) throw new Error('no picture of the field');
  there.free();
  const plane = await WorkerSession.start({ planner: 'pso', scene: 'sphere' });
  const context = document.createElement('canvas').getContext('2d');
  const painted = await plane.paintField(context, [-5, -5], [5, 5], ['#102030', '#102030']);
  const [red, green, blue, opacity] = context.getImageData(20, 20, 1, 1).data;
  if (!painted || red > 0x10 * 1.26 || red < 0x10 || opacity !== 255) throw new Error('painted ' + [painted, red, green, blue, opacity]);
  plane.free();
  const session = new Session(${JSON.stringify(SETUP)});
  while (session.status === 'running') session.step(10);
  document.body.textContent = session.outcome().hash;
  document.title = 'done';
  session.free();`
const html = (script) =>
  `<!doctype html><html lang="en"><meta charset="utf-8"><title>wait</title><link rel="icon" href="data:,"><body></body><script type="module"${script}</script></html>`

test('a static page without a bundler runs it from the unpacked tarball, with the shell’s hash', async (t) => {
  const site = join(project, 'site')
  mkdirSync(site)
  run('tar', ['-xzf', tarball, '-C', site])
  cpSync(join(site, 'package'), join(site, 'forage'), { recursive: true })
  writeFileSync(join(site, 'index.html'), html(`>${script('./forage/forage.js', './forage/worker.js')}`))
  const { hash } = inShell(SETUP)

  await t.test('from a server that knows what wasm is', async () => {
    const server = await serve(site)
    const { text, said } = await look(server.address).finally(server.close)
    assert.deepEqual([text, said], [hash, []])
  })
  await t.test('from one that does not: slower, and it says so', async () => {
    const server = await serve(site, { '.wasm': 'text/plain' })
    const { text, said } = await look(server.address).finally(server.close)
    assert.equal(text, hash)
    assert.ok(
      said.some((line) => line.startsWith('warning:') && line.includes('application/wasm')),
      said.join('\n'),
    )
  })
  await t.test('the book’s page', async () => {
    writeFileSync(
      join(site, 'example.html'),
      `<!doctype html><title>wait</title><link rel="icon" href="data:,"><body></body>${example('html', 'forage.js').replace('</script>', "document.title = 'done: ' + vertices.length;</script>")}`,
    )
    const server = await serve(site)
    await look(`${server.address}example.html`).finally(server.close)
  })
})

test('a Vite project bundles it, wasm and all', async () => {
  const app = join(project, 'app')
  mkdirSync(app)
  writeFileSync(join(app, 'index.html'), html(' src="./main.js">'))
  writeFileSync(join(app, 'main.js'), script('forage-lab', 'forage-lab/worker'))
  run('node', [join(root, 'www/node_modules/vite/bin/vite.js'), 'build', '--base', './', '--target', 'es2023', '--logLevel', 'error'], app)
  const built = run('find', ['dist', '-name', '*.wasm'], app).trim().split('\n')
  assert.ok(built.length > 5, built.join('\n'))
  const server = await serve(join(app, 'dist'))
  const { text } = await look(server.address).finally(server.close)
  assert.equal(text, inShell(SETUP).hash)
})
