// What parts share comes in small files, one for each set of parts that share something. Here they become two: `common` for parts
// that need little, `shared` for the others. Prints the files of each part as JSON.
//   node package/merge.mjs FOLDER
import { execFileSync } from 'node:child_process'
import { readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs'

const [folder] = process.argv.slice(2)
/** Parts of little code: all that they share with others is loaded for each of them, and nothing else. */
const SMALL = ['links', 'statistics']

// The tool says in its script which parts need a file.
const script = readFileSync(`${folder}/__wasm_split.js`, 'utf8')
const chunks = [...script.matchAll(/\/\* ([\w, ]+) \*\/\s*const __(chunk_\d+) /g)].map(([, parts, file]) => ({
  parts: parts.split(', '),
  file,
}))
const parts = [...script.matchAll(/__wasm_split_load_(\w+) /g)].map(([, part]) => part)
if (chunks.length === 0 || parts.length === 0) throw new Error(`${folder}/__wasm_split.js is not as expected`)

const features = ['bulk-memory', 'nontrapping-float-to-int', 'sign-ext', 'mutable-globals', 'reference-types', 'multivalue', 'simd']
const enabled = features.map((feature) => `--enable-${feature}`)
const run = (tool, ...args) => execFileSync(tool, [...enabled, ...args], { encoding: 'utf8', maxBuffer: 1 << 28 })

// All import the same memory and table, which in one module must be one import: they are given those of a module that passes on its own.
const imports = new Map()
for (const { file } of chunks) {
  if (imports.size === 3) break
  const text = run('wasm-dis', `${folder}/${file}.wasm`)
  for (const [, name, kind, type] of text.matchAll(/\(import "__wasm_split" "(\w+)" \((memory|table|global) \S+ ([^\n]*)\)\)\n/g))
    imports.set(kind, `(import "base" "${name}" (${kind} $${kind} ${type})) (export "${name}" (${kind} $${kind}))`)
}
if (imports.size < 3) throw new Error(`the parts share only ${[...imports.keys()]}`)
writeFileSync(`${folder}/base.wat`, `(module ${['memory', 'table', 'global'].map((kind) => imports.get(kind)).join(' ')})`)
run('wasm-as', `${folder}/base.wat`, '-o', `${folder}/base.wasm`)

for (const name of ['common', 'shared']) {
  const files = chunks.filter(({ parts }) => parts.some((part) => SMALL.includes(part)) === (name === 'common')).map(({ file }) => file)
  const given = files.flatMap((file) => [`${folder}/${file}.wasm`, file])
  run('wasm-merge', `${folder}/base.wasm`, '__wasm_split', ...given, '-g', '-o', `${folder}/merged.wasm`)
  // What the module between exports is nothing that the others need.
  run('wasm-opt', `${folder}/merged.wasm`, '-g', '--remove-exports=*', '-o', `${folder}/${name}.wasm`)
  for (const file of [...files, 'merged']) rmSync(`${folder}/${file}.wasm`)
}
rmSync(`${folder}/base.wat`)
rmSync(`${folder}/base.wasm`)
const files = (part) => [...(SMALL.includes(part) ? ['common'] : ['common', 'shared']), part]
for (const part of parts) renameSync(`${folder}/split_${part}.wasm`, `${folder}/${part}.wasm`)
writeFileSync(`${folder}/parts.json`, JSON.stringify(Object.fromEntries(parts.sort().map((part) => [part, files(part)]))))
