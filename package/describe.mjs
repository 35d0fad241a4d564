// Writes the package's package.json and the entries for Node, for the modules that are built.
import { execFileSync } from 'node:child_process'
import { existsSync, readdirSync, writeFileSync } from 'node:fs'

const folder = process.argv[2]
const { packages } = JSON.parse(execFileSync('cargo', ['metadata', '--no-deps', '--format-version', '1'], { encoding: 'utf8' }))
const crate = packages.find(({ name }) => name === 'forage-lab')
const modules = readdirSync(folder).flatMap((file) => (file.endsWith('_bg.wasm') ? [file.slice(0, -'_bg.wasm'.length)] : []))

/** How a module is imported: the one with everything by the package's name. */
const path = (module) => (module === 'forage' ? '.' : `./${module}`)
const node = (module) => (module === 'forage' ? 'node' : `${module}.node`)

for (const module of modules) {
  writeFileSync(
    `${folder}/${node(module)}.js`,
    `// The entry for Node: reads the wasm from disk, so that an import is ready at once.
import { readFileSync } from 'node:fs'
import { initSync } from './${module}.js'

initSync({ module: readFileSync(new URL('./${module}_bg.wasm', import.meta.url)) })

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
const description = {
  name: crate.name,
  type: 'module',
  description: crate.description,
  version: crate.version,
  license: crate.license,
  keywords: crate.keywords,
  files: [...files, 'README.md', 'LICENSE-MIT', 'LICENSE-APACHE', 'THIRD-PARTY.md'].filter((file) => existsSync(`${folder}/${file}`)),
  main: './node.js',
  module: './forage.js',
  types: './forage.d.ts',
  // Without them a bundler for Node would leave out that they read the wasm.
  sideEffects: modules.map((module) => `./${node(module)}.js`),
  exports: {
    ...Object.fromEntries(modules.map((module) => [path(module), entry(module)])),
    ...Object.fromEntries(modules.map((module) => [`./${module}_bg.wasm`, `./${module}_bg.wasm`])),
    './package.json': './package.json',
  },
}
writeFileSync(`${folder}/package.json`, `${JSON.stringify(description, null, 2)}\n`)
