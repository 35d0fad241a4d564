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

/** How the page finds workers and the core: as files next to its own. */
export const pageHost: Host = {
  worker: (kind) =>
    kind === 'run'
      ? new Worker(new URL('../../engine/host/run.worker.ts', import.meta.url), { type: 'module' })
      : new Worker(new URL('../../engine/host/trial.worker.ts', import.meta.url), { type: 'module' }),
  core: () => (compiled ??= compile().catch(() => (compiled = undefined))),
}
