// The Node entry: reads the wasm from disk, so that `import { Session } from 'forage-lab'` works at once.
import { readFileSync } from 'node:fs'
import { initSync } from './forage.js'

initSync({ module: readFileSync(new URL('./forage_bg.wasm', import.meta.url)) })

export * from './forage.js'

/** In Node everything is ready on import; this keeps code that calls `await init()` working. */
export default async function init() {}
