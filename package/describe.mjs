// Completes the package: its words, its catalogue, the entries for Node, and its package.json.
//   node package/describe.mjs FOLDER SHELL
import { execFileSync } from 'node:child_process'
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { pattern } from './fluent.mjs'

const [folder, shell] = process.argv.slice(2)
const require = createRequire(new URL('../www/package.json', import.meta.url))
const run = (file, ...words) => execFileSync(file, words, { encoding: 'utf8', maxBuffer: 1 << 28 })
const crate = JSON.parse(run('cargo', 'metadata', '--no-deps', '--format-version', '1')).packages.find(({ name }) => name === 'forage-lab')
const modules = readdirSync(folder).flatMap((file) => (file.endsWith('_bg.wasm') ? [file.slice(0, -'_bg.wasm'.length)] : []))
/** The one with everything has its English inside. */
const light = modules.filter((module) => module !== 'forage')
const path = (module) => (module === 'forage' ? '.' : `./${module}`)
const node = (module) => (module === 'forage' ? 'node' : `${module}.node`)

const catalogue = run(shell, 'list', '--json')
writeFileSync(`${folder}/catalogue.json`, catalogue)
// What a module's `catalogue()` asks for: the symbols of explanations are known to the shell only.
writeFileSync(`${folder}/symbols.js`, `export const symbols = () => ${JSON.stringify(JSON.parse(catalogue).symbols)}\n`)

// Words: of each module those whose keys it carries.
const messages = Object.fromEntries(JSON.parse(run(shell, 'list', '--messages')).map((message) => [message.key, pattern(message)]))
mkdirSync(`${folder}/locales/en`, { recursive: true })
writeFileSync(`${folder}/locales/en.json`, JSON.stringify(messages))
for (const module of light) {
  const carried = readFileSync(`${folder}/${module}_bg.wasm`, 'latin1')
  const known = Object.entries(messages).filter(([key]) => carried.includes(key))
  writeFileSync(`${folder}/locales/en/${module}.json`, JSON.stringify(Object.fromEntries(known)))
}

// What says them, with the library that reads the patterns inside.
const { build } = await import(require.resolve('rolldown'))
await build({
  input: new URL('words.js', import.meta.url).pathname,
  resolve: { modules: [new URL('../www/node_modules', import.meta.url).pathname] },
  output: { file: `${folder}/words.js`, format: 'esm', minify: true },
  logLevel: 'warn',
})
writeFileSync(
  `${folder}/words.d.ts`,
  `/** A function that says a message, for \`speakBy\`: undefined where it has no words. */
export type Say = (key: string, args: Record<string, number | string>) => string | undefined

/** Says messages in a language by its patterns: \`locales/en/swarm.json\`, or a translation of it. */
export function speaker(locale: string, patterns: Record<string, string>): Say
`,
)

for (const module of modules) {
  const speaks = light.includes(module)
  writeFileSync(
    `${folder}/${node(module)}.js`,
    `// The entry for Node: reads the wasm from disk, so that an import is ready at once.
import { readFileSync } from 'node:fs'
import { initSync${speaks ? ', speakBy' : ''} } from './${module}.js'
${speaks ? "import { speaker } from './words.js'\n" : ''}
const read = (path) => readFileSync(new URL(path, import.meta.url))
initSync({ module: read('./${module}_bg.wasm') })
${speaks ? `speakBy(speaker('en', JSON.parse(read('./locales/en/${module}.json'))))\n` : ''}
export * from './${module}.js'

/** In Node everything is ready on import; this keeps code that calls \`await init()\` working. */
export default async function init() {}
`,
  )
  writeFileSync(
    `${folder}/${node(module)}.d.ts`,
    `export * from './${module}.js'

/** In Node everything is ready on import; this keeps code that calls \`await init()\` working. */
export default function init(): Promise<void>
`,
  )
}

// The glue of wasm-bindgen calls a freed object's methods with no address. Here they say so by name, and to free twice does nothing.
for (const module of modules) {
  const file = `${folder}/${module}.js`
  const glue = readFileSync(file, 'utf8')
  if (glue.includes('freedOnes')) continue
  const told = glue
    .replaceAll(/this\.__wbg_ptr = 0;(?=\s+(\w+)Finalization)/g, "leave(this, '$1');")
    .replaceAll('    free() {\n', '    free() {\n        if (freedOnes.has(this)) return;\n')
  const classes = glue.match(/^export class /gm)?.length
  if (told.split('leave(this').length !== classes + 1 || told.split('freedOnes').length !== classes + 1)
    throw new Error(`${file}: its classes are not as expected`)
  writeFileSync(
    file,
    `${told}
const freedOnes = new WeakSet();
function leave(object, name) {
    freedOnes.add(object);
    Object.defineProperty(object, '__wbg_ptr', { get() { throw freed(name); } });
}
`,
  )
}

const entry = (module) => ({
  node: { types: `./${node(module)}.d.ts`, default: `./${node(module)}.js` },
  types: `./${module}.d.ts`,
  default: `./${module}.js`,
})
const files = modules.flatMap((module) => [
  `${module}_bg.wasm`,
  `${module}_bg.wasm.d.ts`,
  `${module}.js`,
  `${module}.d.ts`,
  `${node(module)}.js`,
  `${node(module)}.d.ts`,
])
const others = [
  'symbols.js',
  'words.js',
  'words.d.ts',
  'locales',
  'catalogue.json',
  'README.md',
  'LICENSE-MIT',
  'LICENSE-APACHE',
  'THIRD-PARTY.md',
]
const description = {
  name: crate.name,
  type: 'module',
  description: crate.description,
  version: crate.version,
  license: crate.license,
  keywords: crate.keywords,
  files: [...files, ...others].filter((file) => existsSync(`${folder}/${file}`)),
  main: './node.js',
  module: './forage.js',
  types: './forage.d.ts',
  // Without them a bundler for Node would leave out that they read the wasm.
  sideEffects: modules.map((module) => `./${node(module)}.js`),
  exports: {
    ...Object.fromEntries(modules.map((module) => [path(module), entry(module)])),
    ...Object.fromEntries(modules.map((module) => [`./${module}_bg.wasm`, `./${module}_bg.wasm`])),
    './words': { types: './words.d.ts', default: './words.js' },
    './locales/*': './locales/*',
    './catalogue.json': './catalogue.json',
    './package.json': './package.json',
  },
}
writeFileSync(`${folder}/package.json`, `${JSON.stringify(description, null, 2)}\n`)
