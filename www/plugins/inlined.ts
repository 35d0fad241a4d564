import { readFile } from 'node:fs/promises'
import { resolve } from 'node:path'
import { promisify } from 'node:util'
import { gzip } from 'node:zlib'
import { build, type InlineConfig, type Plugin, type Rolldown } from 'vite'

const ID = 'virtual:inlined'
const RESOLVED = `\0${ID}`
const pack = promisify(gzip)

/** Where files of the package are is nobody's business who is given them. */
export const unaddressed = (core: string): Plugin => ({
  name: 'forage-unaddressed',
  enforce: 'pre',
  transform: {
    filter: { id: /\.js$/ },
    handler: (code, id) =>
      id.startsWith(core) ? { code: code.replace(/new URL\([^,()]+, import\.meta\.url\)/g, 'undefined'), map: null } : undefined,
  },
})

async function scriptOf(entry: string, config: InlineConfig): Promise<string> {
  const built = await build({
    ...config,
    configFile: false,
    logLevel: 'error',
    build: {
      ...config.build,
      write: false,
      rolldownOptions: {
        checks: { pluginTimings: false },
        transform: { define: { 'import.meta': '{}' } },
        input: entry,
        output: { format: 'iife', codeSplitting: false },
      },
    },
  })
  const { output } = (Array.isArray(built) ? built[0] : built) as Rolldown.RolldownOutput
  const [script, ...others] = output
  if (script?.type !== 'chunk' || others.length > 0) throw new Error(`${entry} is more than one script`)
  return script.code
}

/**
 * Provides `virtual:inlined`: the scripts of threads, and the core's files by name, each compressed by gzip and in base64.
 * @param core the folder that the wasm package was built into
 * @param files its files that are needed
 * @param threads where each thread's script is
 * @param config how those are built
 */
export function inlined(core: string, files: readonly string[], threads: Readonly<Record<string, string>>, config: InlineConfig): Plugin {
  const packed = async (bytes: Buffer | string): Promise<string> => (await pack(bytes, { level: 9 })).toString('base64')
  return {
    name: 'forage-inlined',
    resolveId: (id) => (id === ID ? RESOLVED : undefined),
    async load(id) {
      if (id !== RESOLVED) return undefined
      const scripts: [string, string][] = []
      for (const [name, entry] of Object.entries(threads)) scripts.push([name, await packed(await scriptOf(entry, config))])
      const all = Object.fromEntries(
        await Promise.all(files.map(async (file) => [file, await packed(await readFile(resolve(core, file)))] as const)),
      )
      return `export const threads = ${JSON.stringify(Object.fromEntries(scripts))}\nexport const files = ${JSON.stringify(all)}`
    },
  }
}
