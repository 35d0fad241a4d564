// Completes the package: what is in which part, words, catalogue, entries, types and package.json.
//   node package/complete.mjs FOLDER PARTS SHELL   PARTS: the files of each part, as optimise.mjs has written it
import { execFileSync } from 'node:child_process'
import { copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { resolve } from 'node:path'
import { pathToFileURL } from 'node:url'
import { gzipSync } from 'node:zlib'
import { languageOf, saidAt, tagsOf } from '../scripts/languages/folder.mjs'
import { pattern } from './fluent.mjs'
import { described } from './texts.js'

const [folder, list, shell] = process.argv.slice(2)
const require = createRequire(new URL('../www/package.json', import.meta.url))
const run = (file, ...words) => execFileSync(file, words, { encoding: 'utf8', maxBuffer: 1 << 28 })
const read = (file) => readFileSync(`${folder}/${file}`)
const write = (file, text) => writeFileSync(`${folder}/${file}`, text)
const crate = JSON.parse(run('cargo', 'metadata', '--no-deps', '--format-version', '1')).packages.find(({ name }) => name === 'forage-lab')
const files = JSON.parse(readFileSync(list, 'utf8'))
const parts = Object.keys(files)

const text = run(shell, 'list', '--json')
const catalogue = JSON.parse(text)
write('catalogue.json', text)
write(
  'catalogue.js',
  `/** All that ships: planners with their parameters, scenes, generators. */
export const catalogue = () => JSON.parse(text)
const text = ${JSON.stringify(JSON.stringify(catalogue))}
`,
)

// Words: of each part those whose keys it carries, in its own files or in what it shares. What a language lacks is said in English.
const locales = process.env.LOCALES ?? new URL('../locales', import.meta.url).pathname
const english = Object.fromEntries(JSON.parse(run(shell, 'list', '--messages')).map((message) => [message.key, pattern(message)]))
const carried = (names) => names.map((name) => read(`${name}.wasm`).toString('latin1'))
const keysOf = (texts) => Object.keys(english).filter((key) => texts.some((text) => text.includes(key)))
// That the module is dead is said without it.
const first = keysOf([...carried(['forage_bg']), read('guard.js').toString()])
const keys = { swarm: first }
for (const part of parts) keys[part] = keysOf(carried(files[part])).filter((key) => !first.includes(key))
const known = Object.keys(english).filter((key) => !key.startsWith('shell-'))
const tags = ['en', ...tagsOf(locales)]
for (const tag of tags) {
  const language = tag === 'en' ? { messages: {}, texts: {} } : languageOf(`${locales}/${tag}`)
  const wordsOf = (own) => JSON.stringify(Object.fromEntries(own.map((key) => [key, language.messages[key]?.says || english[key]])))
  mkdirSync(`${folder}/locales/${tag}`, { recursive: true })
  write(`locales/${tag}.json`, wordsOf(known))
  for (const [part, own] of Object.entries(keys)) write(`locales/${tag}/${part}.json`, wordsOf(own))
  if (tag === 'en') continue
  const texts = Object.entries(described(catalogue)).map(([path, text]) => saidAt(language.texts[text], path) || text)
  write(`locales/${tag}/catalogue.json`, JSON.stringify(texts))
}

// What comes with its library inside: what says messages, and sessions in threads.
const { build } = await import(require.resolve('rolldown'))
const bundle = (file, replaced = {}) =>
  build({
    input: new URL(file, import.meta.url).pathname,
    // The package's own files and Node's are not repeated.
    external: (name) => name.startsWith('node:') || own.includes(name),
    // The interpreter's glue for pages is all that Node needs, too.
    resolve: { modules: [new URL('../www/node_modules', import.meta.url).pathname], conditionNames: ['browser', 'import', 'default'] },
    transform: { define: replaced },
    output: { file: `${folder}/${file}`, format: 'esm', minify: true, codeSplitting: false },
    logLevel: 'warn',
  })
const own = ['catalogue', 'core', 'glue', 'guard', 'interpreter', 'loader', 'node', 'own', 'page', 'parts', 'words'].map(
  (name) => `./${name}.js`,
)
await bundle('words.js')
for (const file of ['own', 'testing', 'testing.node', 'isolate', 'isolate.node']) await bundle(`${file}.js`)

// The interpreter, with the script that runs in it before an author's code.
const { output } = await build({
  input: new URL('../crates/isolate/src/js/inside.js', import.meta.url).pathname,
  output: { format: 'iife', minify: true },
  write: false,
  logLevel: 'warn',
})
await bundle('interpreter.js', { INSIDE: JSON.stringify(output[0].code) })
copyFileSync(require.resolve('@jitl/quickjs-wasmfile-release-sync/wasm'), `${folder}/interpreter.wasm`)

// The glue of wasm-bindgen calls a freed object's methods with no address. Here they say so by name, to free twice does nothing,
// and no call reaches a module that broke down.
let glue = read('glue.js').toString()
/** Replaces what must be there so many times. */
const replace = (found, by, times) => {
  if (glue.match(found)?.length !== times) throw new Error(`glue.js has not ${times} times ${found}`)
  glue = glue.replace(found, by)
}
const classes = glue.match(/^export class /gm)?.length
const methods = glue.match(/this\.__wbg_inst !== undefined/g)?.length
replace(/this\.__wbg_ptr = 0;(?=\s+(\w+)Finalization)/g, "leave(this, (reset) => freed('$1', reset));", classes)
replace(/ {4}free\(\) \{\n/g, '$&        if (isGone(this, __wbg_instance_id)) return;\n', classes)
replace(/\bwasm = (\w+)\.exports;/g, 'wasm = guarded($1.exports);', 2)
glue = glue.replace(/^export class (\w+) \{\n[\s\S]*?^\}/gm, (text, name) =>
  text.replace(/if \(this\.__wbg_inst !== undefined [\s\S]*?\}/g, `mustBeOf(this, __wbg_instance_id, (reset) => freed('${name}', reset));`),
)
replace(/mustBeOf\(/g, '$&', methods)
write('glue.js', `import { guarded, isGone, leave, mustBeOf } from './guard.js';\n${glue}`)

// Where the files are: addresses that bundlers find.
const wasm = ['forage_bg', ...new Set(Object.values(files).flat())]
const address = (file) => `() => new URL('./${file}', import.meta.url)`
const tableOf = (names, file) => `{\n${names.map((name) => `  ${name}: ${address(file(name))},\n`).join('')}}`
const partsFile = (holds, scenes = []) => `// What is in which part of the module, and where. Written by package/complete.mjs.
export const urls = ${tableOf(wasm, (name) => `${name}.wasm`)}
export const files = ${JSON.stringify(files)}
export const holds = ${JSON.stringify(holds)}
export const languages = ${JSON.stringify(tags)}
export const scenes = ${tableOf(scenes, (part) => `scenes/${part}.json`)}
/** What code that is not trusted runs in. */
export const interpreter = ${address('interpreter.wasm')}
`

const wordsIn = (tag) => `  '${tag}': ${tableOf(Object.keys(keys), (part) => `locales/${tag}/${part}.json`).replaceAll('\n', '\n  ')},\n`
write(
  'languages.js',
  `// The languages, and where the words of each part are. Written by package/complete.mjs.
export { speaker } from './words.js'
export const words = {\n${tags.map(wordsIn).join('')}}
`,
)

// What each part holds, as it says itself: a name that nothing has is refused with those that there are.
write('parts.js', partsFile({}))
const at = (file) => pathToFileURL(resolve(folder, file)).href
const core = await import(at('glue.js'))
const loader = await import(at('loader.js'))
loader.share(core.initSync({ module: read('forage_bg.wasm') }))
const refused = (call) => {
  try {
    call()
  } catch ({ code, allowed }) {
    return code === 'unknown' ? allowed.split(', ').filter(Boolean) : []
  }
  return []
}
const fileOf = (name) => JSON.parse(readFileSync(new URL(`../scenes/${name}.json`, import.meta.url), 'utf8'))
const session = new core.Session({ planner: catalogue.planners[0].name, scene: fileOf(catalogue.scenes[0].name) })
/** A follower is known where it is not refused as unknown: it has nothing to follow here. */
const follows = (name) => {
  try {
    return session[name]({}) === null
  } catch {
    return false
  }
}

// A session in a thread has the same members.
const members = Object.entries(Object.getOwnPropertyDescriptors(core.Session.prototype)).filter(
  ([name]) => !name.startsWith('__') && !['constructor', 'free', 'paintField'].includes(name),
)
const namesOf = (kind) => JSON.stringify(members.filter(([, member]) => member[kind]).map(([name]) => name))
for (const file of ['worker', 'worker.node', 'session-worker', 'session-worker.node'])
  await bundle(`${file}.js`, { METHODS: namesOf('value'), GETTERS: namesOf('get') })

const asked = {
  planner: () => refused(() => core.checkParameter('', '', '', 0)),
  kind: () => refused(() => core.checkParameter(catalogue.planners[0].name, '', '', 0)),
  generator: () => refused(() => core.generateScene('', {}, 1)),
  follower: () => ['drive', 'motion'].filter(follows),
}
const holds = Object.fromEntries(
  Object.entries(asked).map(([field, names]) => [field, Object.fromEntries(names().map((name) => [name, []]))]),
)
for (const part of parts) {
  for (const file of loader.filesOf([part])) loader.linkFile(file, new WebAssembly.Module(read(`${file}.wasm`)))
  loader.addParts([part])
  for (const [field, names] of Object.entries(asked)) for (const name of names()) holds[field][name] ??= [part]
}
for (const { name, parameters } of catalogue.planners) {
  const needed = parameters.flatMap((parameter) => (typeof parameter.default === 'string' ? (holds.planner[parameter.default] ?? []) : []))
  holds.planner[name] = [...new Set([...holds.planner[name], ...needed])]
}
holds.scene = Object.fromEntries(catalogue.scenes.map(({ name, kind }) => [name, holds.kind[kind]]))
const shipped = { planner: catalogue.planners, scene: catalogue.scenes, generator: catalogue.generators }
for (const [field, entries] of Object.entries(shipped))
  for (const { name } of entries) if (!holds[field][name]) throw new Error(`no part holds the ${field} ${name}`)
holds.role = {}
// What reads a scene's field is asked for as a tool.
holds.field = { expression: ['formulas'], instance: ['formulas'], objective: ['code'], objectives: ['code'] }
holds.tool = Object.fromEntries(parts.map((part) => [part, [part]]))

// The scenes that ship are files apart: those of a part come with it.
const partOf = ({ kind }) => holds.kind[kind][0] ?? 'swarm'
const withScenes = [...new Set(catalogue.scenes.map(partOf))]
mkdirSync(`${folder}/scenes`, { recursive: true })
for (const part of withScenes)
  write(`scenes/${part}.json`, JSON.stringify(catalogue.scenes.filter((scene) => partOf(scene) === part).map(({ name }) => fileOf(name))))
write('parts.js', partsFile(holds, withScenes))

// What the bundled libraries ask for.
const notice = (name) => {
  const at = new URL(`../www/node_modules/${name}/`, import.meta.url)
  const { version, license } = JSON.parse(readFileSync(new URL('package.json', at), 'utf8'))
  const text = new URL('LICENSE', at)
  if (!['Apache-2.0', 'MIT'].includes(license)) throw new Error(`${name} has another licence: ${license}`)
  const title = license === 'MIT' ? 'MIT License' : 'Apache License 2.0'
  return `\n## ${title}\n\n- ${name} ${version}\n\n\`\`\`\n${readFileSync(existsSync(text) ? text : `${folder}/LICENSE-APACHE`, 'utf8').trim()}\n\`\`\`\n`
}
write(
  'THIRD-PARTY.md',
  `${read('THIRD-PARTY.md')}${['@fluent/bundle', 'comlink', 'quickjs-emscripten-core', '@jitl/quickjs-wasmfile-release-sync'].map(notice).join('')}`,
)

// The entries. What only the loader calls is not for users.
const inner = new Set([
  'add',
  'addScenes',
  'bringBy',
  'freed',
  'lent',
  'lentList',
  'registerPlanner',
  'speakBy',
  'start',
  'initSync',
  '__wbg_reset_state',
])
const names = [...glue.matchAll(/^export (?:class|function) (\w+)/gm)].map(([, name]) => name).filter((name) => !inner.has(name))
const passed = `\nexport { ${names.join(', ')} } from './glue.js'\nexport { ModuleDead } from './guard.js'\n`
write('core.js', `${read('core.js')}\nexport const shapes = ${JSON.stringify(catalogue.shapes)}\n`)
for (const entry of ['core.js', 'page.js', 'node.js']) write(entry, read(entry) + passed)
write('forage.js', `export { default } from './page.js'\nexport * from './page.js'\nexport { catalogue } from './catalogue.js'\n`)
for (const part of ['swarm', ...parts]) {
  const needed = part === 'swarm' ? '' : `'${part}'`
  write(
    `${part}.js`,
    `import { load } from './page.js'\n\nexport * from './page.js'\n\n/** Loads this part of the module, with what every run needs. */\nexport default function init() {\n  return load(${needed})\n}\n`,
  )
  write(
    `${part}.node.js`,
    `import { loadNow } from './node.js'\n\nloadNow(${needed})\nexport { default } from './node.js'\nexport * from './node.js'\n`,
  )
}

// Types. Names are those that there are.
const oneOf = (names) => [...new Set(names)].map((name) => `'${name}'`).join(' | ')
const typeOf = ({ type, options }) =>
  ({ integer: 'number', flag: 'boolean', subset: 'string', choice: options && oneOf(options.map(({ value }) => value)) })[type] ?? type
const taken = (parameters) => parameters.map((parameter) => `${parameter.name}?: ${typeOf(parameter)}`).join('; ')
const named = {
  Kind: oneOf(Object.keys(holds.kind)),
  PlannerName: oneOf(catalogue.planners.map(({ name }) => name)),
  SceneName: oneOf(catalogue.scenes.map(({ name }) => name)),
  GeneratorName: oneOf(catalogue.generators.map(({ name }) => name)),
  LayerName: oneOf([...catalogue.roles, ...catalogue.layers.map(({ role }) => role)]),
  ParametersOf: `{\n${catalogue.planners.map(({ name, parameters }) => `    '${name}': { ${taken(parameters)} }\n`).join('')}}`,
}
let types = read('glue.d.ts').toString()
for (const [name, names] of Object.entries(named)) {
  const open = new RegExp(`^export type ${name} = (?:string|Record<.*>)$`, 'm')
  if (!open.test(types)) throw new Error(`glue.d.ts has no ${name}`)
  types = types.replace(open, () => `export type ${name} = ${names}`)
}
const until = types.indexOf('export type InitInput')
if (until < 0) throw new Error('glue.d.ts is not as expected')
write(
  'forage.d.ts',
  `${types.slice(0, until).trimEnd()}

declare global {
  interface SymbolConstructor {
    /** Here for libraries of types that do not know it yet: \`using session = new Session(…)\` frees it at the end of its block. */
    readonly dispose: unique symbol;
  }
}

/** A part of the module other than the first one, which has the swarms, on functions and among discs. */
export type Part = ${parts.map((part) => `'${part}'`).join(' | ')};

/** Loads parts of the module; those that are there are not loaded again. In Node calls load what they need by themselves. */
export function load(...parts: Part[]): Promise<void>;

/** Loads the code of parts, and not their words: texts are keys until \`load\` has been called. In Node it is \`load\`. */
export function loadCode(...parts: Part[]): Promise<void>;

/** The parts that a run needs, as far as its names are known. */
export function partsOf(setup: UncheckedSetup): Part[];

/**
 * Calls \`make\`, loads what it turns out to need, and calls it again: \`const session = await ready(() => new Session(setup))\`.
 */
export function ready<T>(make: () => T): Promise<T>;

/**
 * What every call throws after one broke down (out of memory or out of stack) until reset(): the module's memory is in a state that
 * nobody knows.
 */
export class ModuleDead extends Error {
  readonly code: 'module-dead';
  /** How it broke down. */
  readonly cause: unknown;
}

/** Restarts the module, with the parts that were there. Sessions and trials of before are gone: their methods say so. */
export function reset(): void;

/** The shapes in a frame's table of spans, by number. */
export const shapes: readonly Shape[];

/** All that ships: planners with their parameters, scenes, generators. */
export function catalogue(): Catalogue;

export type * from './planner.js';

/**
 * Adds a planner in JavaScript to those that are known, in the place of one of the same name that was added before. It is in this thread
 * only: sessions in other threads do not know it.
 *
 * \`\`\`js
 * const { name } = await register({
 *   name: 'random-search', kinds: ['function'],
 *   start: () => ({ cost: Infinity, position: null }),
 *   advance(state, { box, evaluate, random }) {
 *     const position = box.low.map((low, k) => low + (box.high[k] - low) * random())
 *     const cost = evaluate(position)
 *     return cost < state.cost ? { cost, position } : state
 *   },
 *   best: ({ cost, position }) => position && { cost, position },
 * })
 * const session = new Session({ planner: name, scene: 'sphere', seed: 5 })
 * \`\`\`
 *
 * Throws an \`Error\` with the \`field\` that is wrong, its \`value\` and what is \`allowed\`.
 */
export function register<State extends object>(planner: import('./planner.js').PlannerInJavaScript<State>): Promise<Catalogue['planners'][number]>;

/** A function that says a message: undefined where it has no words. */
export type Say = (key: string, args: Record<string, number | string>) => string | undefined;

/** Sets how messages are said. Without it they are English. */
export function speakBy(say: Say): void;

/** A language that messages are said in. */
export type Language = ${oneOf(tags)};

/**
 * Has messages (errors, explanations, events) said in another language from now on. A catalogue in it is
 * \`translated(catalogue(), texts)\` of \`forage-lab/texts\`. Throws if there is no such language.
 */
export function speakIn(language: Language): Promise<void>;

/**
 * From where the package's files come, if not from where the package is: \`serve('grid.wasm')\` and
 * \`serve('locales/en/grid.json')\` promise a \`Response\`. To be called before anything is loaded. In Node they are read from where they are.
 */
export function serveBy(serve: (file: string) => Promise<object>): void;

/**
 * In a page, before anything else: loads the swarms and links. In Node everything is ready on import.
 * @param source where the first part is, if it is not with the package's files, or what it was compiled to
 */
export default function init(source?: string | { readonly href: string } | object): Promise<void>;
`,
)
write(
  'part.d.ts',
  `export * from './forage.js';

/** In a page, before anything else: loads this part of the module, with what every run needs. In Node it is ready on import. */
export default function init(): Promise<void>;
`,
)
write(
  'node.d.ts',
  `export { default } from './forage.js';
export * from './forage.js';
`,
)
write(
  'core.d.ts',
  `export * from './forage.js';

/**
 * The first part by itself, for a picture before any text: until the main entry's \`load()\`, messages are keys.
 * @param source where it is, if it is not with the package's files, or what it was compiled to
 */
export function begin(source?: string | { readonly href: string } | object): Promise<unknown>;
`,
)
write(
  'words.d.ts',
  `import type { Say } from './forage.js';

/** Says messages in a language by its patterns: \`locales/en.json\`, or a translation of it. \`add\` gives it more. */
export function speaker(locale: string, patterns: Record<string, string>): Say & { add(patterns: Record<string, string>): void };
`,
)

write(
  'texts.d.ts',
  `import type { Catalogue } from './forage.js';

/** A catalogue in another language: \`texts\` are those of \`locales/TAG/catalogue.json\`, which belong to this version's catalogue; throws for others. */
export function translated(catalogue: Catalogue, texts: readonly string[]): Catalogue;

/** A text with its numbers replaced by \`{1}\`, \`{2}\` …, and the numbers: texts that differ in numbers only are translated once. */
export function numbered(text: string): { text: string; numbers: string[] };

/** A text with numbers put in. */
export function filled(text: string, numbers: readonly string[]): string;
`,
)

// The table of sizes.
const contents = {
  forage_bg: 'always: particle and quantum swarms, among discs and on functions',
  shared: 'with `grid`, `tour`, `arm`, `files`, `generators`, `pictures`',
  common: 'with every other part',
  grid: 'ants, searches of cells, other swarms, drives, tuning',
  tour: 'tours of many stops',
  arm: 'arms and random trees',
  links: 'links',
  files: 'files of other programs',
  generators: 'random scenes',
  formulas: 'functions by formula',
  code: 'functions and planners from code',
  pictures: 'pictures as SVG',
  statistics: 'statistics of many runs',
}
const rows = wasm.map((name) => {
  if (!contents[name]) throw new Error(`README.md: what is in ${name}?`)
  return { name, size: gzipSync(read(`${name}.wasm`), { level: 9 }).length }
})
const size = (bytes) => `${Math.round(bytes / 1000)} kB`
const table = Object.keys(contents).map(
  (name) => `| \`${name}\` | ${size(rows.find((row) => row.name === name).size)} | ${contents[name]} |`,
)
const total = `| | ${size(rows.reduce((sum, { size }) => sum + size, 0))} | all |`
write(
  'README.md',
  read('README.md')
    .toString()
    .replace('@SIZES@', ['| part | size | what for |', '| --- | --- | --- |', ...table, total].join('\n')),
)

const entry = (types, name, node) => ({ types: `./${types}.d.ts`, node: `./${node}.js`, default: `./${name}.js` })
const description = {
  name: crate.name,
  type: 'module',
  description: crate.description,
  version: crate.version,
  license: crate.license,
  keywords: crate.keywords,
  engines: { node: '>=20' },
  // The element's script and the renderer are built with the page, and what is in all of it is listed then.
  files: [
    ...new Set([
      ...readdirSync(folder).filter((file) => !['package.json', 'glue.d.ts'].includes(file)),
      'element.js',
      'render.js',
      'render',
      'sbom.cdx.json',
    ]),
  ],
  main: './node.js',
  module: './forage.js',
  types: './forage.d.ts',
  // They set up what is loaded; the catalogue is left out where nobody asks for it.
  sideEffects: ['./page.js', './node.js', './*.node.js', './session-worker.js', './element.js'],
  exports: {
    '.': entry('forage', 'forage', 'node'),
    ...Object.fromEntries(['swarm', ...parts].map((part) => [`./${part}`, entry('part', part, `${part}.node`)])),
    './isolate': entry('isolate', 'isolate', 'isolate.node'),
    './testing': entry('testing', 'testing', 'testing.node'),
    './worker': entry('worker', 'worker', 'worker.node'),
    './session-worker': entry('session-worker', 'session-worker', 'session-worker.node'),
    './core': { types: './core.d.ts', default: './core.js' },
    './element': { types: './element.d.ts', default: './element.js' },
    './embed': { types: './embed.d.ts', default: './embed.js' },
    './render': { types: './render.d.ts', default: './render.js' },
    './texts': { types: './texts.d.ts', default: './texts.js' },
    './words': { types: './words.d.ts', default: './words.js' },
    './*.wasm': './*.wasm',
    './locales/*': './locales/*',
    './scenes/*': './scenes/*',
    './catalogue.json': './catalogue.json',
    './package.json': './package.json',
  },
}
for (const file of ['README.md', 'LICENSE-MIT', 'LICENSE-APACHE', 'THIRD-PARTY.md'])
  if (!existsSync(`${folder}/${file}`)) throw new Error(`${file} is missing`)
write('package.json', `${JSON.stringify(description, null, 2)}\n`)
