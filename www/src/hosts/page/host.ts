import type { Catalogue } from 'forage-lab'
import catalogue from 'forage-lab/catalogue.json?url'
import core from 'forage-lab/forage_bg.wasm?url'
import type { Host } from '../../engine/host'
import run from '../../engine/host/run.worker?worker&url'
import trial from '../../engine/host/trial.worker?worker&url'
import render from '../../render/render.worker?worker&url'
import { scriptAddress } from '../../ui/trusted'

let compiled: Promise<WebAssembly.Module | undefined> | undefined

/** Not all servers know what wasm is: only what is called so can be compiled while it arrives. */
async function compile(): Promise<WebAssembly.Module> {
  const response = await fetch(core)
  return response.headers.get('content-type') === 'application/wasm'
    ? WebAssembly.compileStreaming(response)
    : WebAssembly.compile(await response.arrayBuffer())
}

async function found(address: string): Promise<Response> {
  const response = await fetch(address)
  if (!response.ok) throw new Error(`${response.status} ${response.statusText}: ${address}`)
  return response
}

/** The address of a file that lies where the page does. */
const here = (file: string): string => new URL(file, location.origin + location.pathname).href

const readCatalogue = async (): Promise<Catalogue> => (await found(catalogue)).json()

const threads = { run, trial, render }

/** How the page finds workers and the core: as files next to its own. */
export const pageHost: Host = {
  worker: (kind) => new Worker(scriptAddress(threads[kind]), { type: 'module' }),
  catalogue: readCatalogue,
  elsewhere: { page: here('.'), element: here('element.js') },
  singleFile: async () => (await found('single-file.html')).text(),
  core: () => (compiled ??= compile().catch(() => (compiled = undefined))),
}
