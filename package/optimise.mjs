// From what the splitter has written, the files that ship: what parts share becomes two files, and every file is optimised.
//   node package/optimise.mjs FOLDER OUT   in FOLDER stay the files before they are optimised, with the names of their functions,
//                                          and parts.json: the files of each part
// One process for all: most of what a small file would take is the start of the optimiser.
import { execFileSync } from 'node:child_process'
import { readdirSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { pathToFileURL } from 'node:url'
import { named } from './neighbours.mjs'

const require = createRequire(new URL('../www/package.json', import.meta.url))
const { default: binaryen } = await import(pathToFileURL(require.resolve('binaryen')))

const [folder, out] = process.argv.slice(2)
/** Parts of little code: all that they share with others is loaded for each of them, and nothing else. */
const SMALL = ['links', 'statistics']
const { Features } = binaryen
const FEATURES =
  Features.BulkMemory |
  Features.BulkMemoryOpt |
  Features.NontrappingFPToInt |
  Features.SignExt |
  Features.MutableGlobals |
  Features.ReferenceTypes |
  Features.Multivalue |
  Features.SIMD128

const read = (file) => {
  const module = binaryen.readBinary(readFileSync(file))
  module.setFeatures(FEATURES)
  return module
}
const write = (module, file) => {
  writeFileSync(file, module.emitBinary())
  module.dispose()
}

/** What parts share comes in small files, one for each set of parts that share something. They become two: `common` for parts that need little, `shared` for the others. */
function merge() {
  // The tool says in its script which parts need a file.
  const script = readFileSync(`${folder}/__wasm_split.js`, 'utf8')
  const chunks = [...script.matchAll(/\/\* ([\w, ]+) \*\/\s*const __(chunk_\d+) /g)].map(([, parts, file]) => ({
    parts: parts.split(', '),
    file,
  }))
  const parts = [...script.matchAll(/__wasm_split_load_(\w+) /g)].map(([, part]) => part)
  if (chunks.length === 0 || parts.length === 0) throw new Error(`${folder}/__wasm_split.js is not as expected`)

  // All import the same memory and table, which in one module must be one import: they are given those of a module that passes on its own.
  const imports = new Map()
  for (const { file } of chunks) {
    if (imports.size === 3) break
    const module = read(`${folder}/${file}.wasm`)
    for (const [, name, kind, type] of module
      .emitText()
      .matchAll(/\(import "__wasm_split" "(\w+)" \((memory|table|global) \S+ ([^\n]*)\)\)\n/g))
      imports.set(kind, `(import "base" "${name}" (${kind} $${kind} ${type})) (export "${name}" (${kind} $${kind}))`)
    module.dispose()
  }
  if (imports.size < 3) throw new Error(`the parts share only ${[...imports.keys()]}`)
  const base = binaryen.parseText(`(module ${['memory', 'table', 'global'].map((kind) => imports.get(kind)).join(' ')})`)
  base.setFeatures(FEATURES)
  write(base, `${folder}/base.wasm`)

  const enabled = ['bulk-memory', 'nontrapping-float-to-int', 'sign-ext', 'mutable-globals', 'reference-types', 'multivalue', 'simd']
  for (const name of ['common', 'shared']) {
    const files = chunks.filter(({ parts }) => parts.some((part) => SMALL.includes(part)) === (name === 'common')).map(({ file }) => file)
    const given = files.flatMap((file) => [`${folder}/${file}.wasm`, file])
    const flags = enabled.map((feature) => `--enable-${feature}`)
    execFileSync('wasm-merge', [...flags, `${folder}/base.wasm`, '__wasm_split', ...given, '-g', '-o', `${folder}/merged.wasm`])
    const module = read(`${folder}/merged.wasm`)
    // What the module between exports is nothing that the others need.
    binaryen.setPassArgument('remove-exports', '*')
    module.runPasses(['remove-exports'])
    binaryen.clearPassArguments()
    write(module, `${folder}/${name}.wasm`)
    for (const file of [...files, 'merged']) rmSync(`${folder}/${file}.wasm`)
  }
  rmSync(`${folder}/base.wasm`)
  const files = (part) => [...(SMALL.includes(part) ? ['common'] : ['common', 'shared']), part]
  for (const part of parts) renameSync(`${folder}/split_${part}.wasm`, `${folder}/${part}.wasm`)
  writeFileSync(`${folder}/parts.json`, JSON.stringify(Object.fromEntries(parts.sort().map((part) => [part, files(part)]))))
}

/** Reads and writes files: no loop in it is worth more bytes. */
const COLD = ['files.wasm']

function optimise(name) {
  binaryen.setShrinkLevel(COLD.includes(name) ? 2 : 0)
  const module = read(`${folder}/${name}`)
  // Twice: the passes leave something for each other.
  module.optimize()
  module.optimize()
  module.runPasses(['merge-locals', 'coalesce-locals', 'reorder-locals', 'vacuum'])
  module.runPasses(['strip-debug', 'strip-producers'])
  const bytes = named(module.emitBinary(), module, binaryen)
  module.dispose()
  const ordered = binaryen.readBinary(bytes)
  ordered.setFeatures(FEATURES)
  ordered.runPasses(['reorder-functions-by-name', 'strip-debug'])
  write(ordered, `${out}/${name}`)
}

binaryen.setDebugInfo(true)
merge()
binaryen.setDebugInfo(false)
binaryen.setOptimizeLevel(3)
binaryen.setOneCallerInlineMaxSize(30)
// What the program wasm-opt does at this level, and the library only when it is asked to.
binaryen.setGenerateStackIR(true)
binaryen.setOptimizeStackIR(true)
for (const name of readdirSync(folder).filter((file) => file.endsWith('.wasm'))) optimise(name)
