import core from 'forage-lab/forage_bg.wasm?url'
import type { Host } from '../../engine/host'

let compiled: Promise<WebAssembly.Module | undefined> | undefined

/** Not all servers know what wasm is: only what is called so can be compiled while it arrives. */
async function compile(): Promise<WebAssembly.Module> {
  const response = await fetch(core)
  return response.headers.get('content-type') === 'application/wasm'
    ? WebAssembly.compileStreaming(response)
    : WebAssembly.compile(await response.arrayBuffer())
}

const threads = {
  run: () => new Worker(new URL('../../engine/host/run.worker.ts', import.meta.url), { type: 'module' }),
  trial: () => new Worker(new URL('../../engine/host/trial.worker.ts', import.meta.url), { type: 'module' }),
  render: () => new Worker(new URL('../../render/render.worker.ts', import.meta.url), { type: 'module' }),
}

/** How the page finds workers and the core: as files next to its own. */
export const pageHost: Host = {
  worker: (kind) => threads[kind](),
  core: () => (compiled ??= compile().catch(() => (compiled = undefined))),
}
