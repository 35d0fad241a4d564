import type { Catalogue } from 'forage-lab'
import { gunzipSync } from 'fflate'
import { files as packed, threads } from 'virtual:inlined'
import type { Files, Host } from '../../engine/host'
import { scriptAddress } from '../../ui/trusted'

const CORE = 'forage_bg.wasm'
const CATALOGUE = 'catalogue.json'

const bytesOf = (base64: string): Uint8Array<ArrayBuffer> => Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))

async function unpacked(name: string): Promise<ArrayBuffer> {
  const stream = new Blob([bytesOf(packed[name] ?? '')]).stream()
  return new Response(stream.pipeThrough(new DecompressionStream('gzip'))).arrayBuffer()
}

/** What is made when it is first asked for. */
function once<T>(make: () => T): () => T {
  let made: { value: T } | undefined
  return () => {
    made ??= { value: make() }
    return made.value
  }
}

const files = once(async (): Promise<Files> => {
  const names = Object.keys(packed).filter((name) => name !== CATALOGUE)
  return Object.fromEntries(await Promise.all(names.map(async (name) => [name, await unpacked(name)] as const)))
})
const core = once(async () => WebAssembly.compile(await unpacked(CORE)))
const catalogue = once(async (): Promise<Catalogue> => JSON.parse(new TextDecoder().decode(await unpacked(CATALOGUE))))
const addresses = Object.fromEntries(
  Object.entries(threads).map(([kind, script]) => [
    kind,
    // Browsers decompress streams only, and a thread is started at once.
    once(() => scriptAddress(URL.createObjectURL(new Blob([gunzipSync(bytesOf(script))], { type: 'text/javascript' })))),
  ]),
)

/** Everything is in one script: threads and the core's files. Threads are classic scripts, for others don't start from a file. */
export const inlinedHost: Host = {
  worker: (kind) => new Worker(addresses[kind]?.() as string | URL),
  core: () => core().catch(() => undefined),
  catalogue,
  files,
}
