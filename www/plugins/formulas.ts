import { readFile, stat } from 'node:fs/promises'
import { resolve } from 'node:path'
import { pathToFileURL } from 'node:url'
import temml from 'temml'
import type { Plugin } from 'vite'

const ID = 'virtual:formulas'
const RESOLVED = `\0${ID}`

/** What this plugin needs of the catalogue: wherever it holds TeX. */
interface Symbols {
  planners: {
    parameters: { symbol: string }[]
    readings: { symbol: string }[]
    formulas: { tex: string; live?: string }[]
  }[]
  drive: {
    parameters: { symbol: string }[]
    columns: { symbol: string }[]
    formulas: { tex: string; live?: string }[]
  }
  /** The TeX strings that only turn up at run time. */
  symbols?: string[]
}

interface Core {
  initSync(options: { module: Uint8Array }): void
  catalogue(): Symbols
}

/**
 * Provides `virtual:formulas`: the catalogue's TeX as MathML, made while building, so that the page ships no TeX engine.
 * @param core the folder that the wasm package was built into
 */
export function formulas(core: string): Plugin {
  const script = resolve(core, 'forage.js')
  const wasm = resolve(core, 'forage_bg.wasm')

  return {
    name: 'forage-formulas',
    resolveId: (id) => (id === ID ? RESOLVED : undefined),
    async load(id) {
      if (id !== RESOLVED) return undefined
      this.addWatchFile(wasm)
      const catalogue = await readCatalogue(script, wasm)
      const { inline, display } = collect(catalogue)
      return [
        `export const inline = ${JSON.stringify(typeset(inline, false))}`,
        `export const display = ${JSON.stringify(typeset(display, true))}`,
      ].join('\n')
    },
  }
}

async function readCatalogue(script: string, wasm: string): Promise<Symbols> {
  const built = await stat(wasm).catch(() => {
    throw new Error(`${wasm} is missing: build the core first (scripts/build-wasm)`)
  })
  // The time makes Node load a rebuilt core anew instead of the one it remembers.
  const core = (await import(/* @vite-ignore */ `${pathToFileURL(script).href}?built=${built.mtimeMs}`)) as Core
  core.initSync({ module: await readFile(wasm) })
  return core.catalogue()
}

function collect({ planners, drive, symbols = [] }: Symbols): { inline: Set<string>; display: Set<string> } {
  const inline = new Set(symbols)
  const display = new Set<string>()
  for (const { parameters, formulas, ...numbers } of [...planners, drive]) {
    const told = 'readings' in numbers ? numbers.readings : numbers.columns
    for (const { symbol } of [...parameters, ...told]) inline.add(symbol)
    for (const { tex, live } of formulas) {
      display.add(tex)
      if (live) display.add(live)
    }
  }
  return { inline, display }
}

function typeset(sources: Set<string>, displayMode: boolean): Record<string, string> {
  return Object.fromEntries([...sources].map((tex) => [tex, mathml(tex, displayMode)]))
}

/** Numbers that stand for `@name@` while TeX is set: spaces come out as they would around the real ones. */
const SLOT = 9_021_000
const FUNCTION = /(<\/(?:mi|mn|msub|msup|mfrac|mtext)>)(?=<mrow><mi>[a-z]{2,}<\/mi><mo>\u2061<\/mo>(?:<mspace[^>]*><\/mspace>)?<\/mrow>(?!<\/msu))/g
const PRIME = /<msup>(<mi>[^<]*<\/mi>)<mo [^>]*class="tml-prime[^>]*>′<\/mo><\/msup>/g

/** MathML, with every `@name@` left in it as `<mtext>@name@</mtext>`. Formulas may break after their outer operators. */
export function mathml(tex: string, displayMode: boolean): string {
  const names: string[] = []
  const source = tex.replace(/@([\w.-]+)@/g, (_, name: string) => `{${SLOT + names.push(name) - 1}}`)
  return temml
    .renderToString(source, { wrap: displayMode ? 'tex' : 'none', throwOnError: true })
    .replace(/<mn>(\d{7})<\/mn>/g, (whole, digits: string) => {
      const name = names[Number(digits) - SLOT]
      return name === undefined ? whole : `<mtext>@${name}@</mtext>`
    })
    .replace(FUNCTION, '$1<mspace width="0.1667em"></mspace>')
    // Text fonts have the prime where it belongs; as a superscript it would be raised twice.
    .replace(PRIME, '<mrow>$1<mo class="prime" lspace="0em" rspace="0em">′</mo></mrow>')
    // At the end of a piece an operator would count as a postfix and lose its spaces.
    .replace(/<mo>([^<]+)<\/mo><\/mrow>(?=<mrow>|<\/math>)/g, '<mo form="infix">$1</mo></mrow>')
    .replace(/^<math>/, displayMode ? '<math displaystyle="true">' : '<math>')
}
