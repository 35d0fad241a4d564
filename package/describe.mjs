// Completes the package.json that wasm-pack wrote: one wasm file, the web glue once, and the Node entry.
import { readFileSync, writeFileSync } from 'node:fs'

const path = process.argv[2]
const description = JSON.parse(readFileSync(path, 'utf8'))
description.type = 'module'
description.files = [
  'forage_bg.wasm',
  'forage_bg.wasm.d.ts',
  'forage.js',
  'forage.d.ts',
  'node.js',
  'node.d.ts',
  'README.md',
  'LICENSE-MIT',
  'LICENSE-APACHE',
  'THIRD-PARTY.md',
]
description.exports = {
  '.': {
    node: { types: './node.d.ts', default: './node.js' },
    types: './forage.d.ts',
    default: './forage.js',
  },
  './forage_bg.wasm': './forage_bg.wasm',
  './package.json': './package.json',
}
description.main = './node.js'
description.module = './forage.js'
description.types = './forage.d.ts'
writeFileSync(path, `${JSON.stringify(description, null, 2)}\n`)
