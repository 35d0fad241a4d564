import { readdir, readFile } from 'node:fs/promises'
import { resolve } from 'node:path'
import temml from 'temml'
import type { Plugin } from 'vite'

const ID = 'virtual:formulas'
const RESOLVED = `\0${ID}`
/** The names that the formulas of those who follow a path have beside those of the planners. */
const FOLLOWERS = ['drive', 'motion'] as const

interface Texts {
  texts?: Record<string, Record<string, string>>
}

/** As `src/ui/markdown.ts` has it. */
const SYMBOL = /\$([^\s$](?:[^$\n]*[^\s$])?)\$(?!\d)/g

interface Follower {
  parameters: { symbol: string }[]
  columns: { symbol: string }[]
  formulas: Formula[]
}

interface Formula {
  tex: string
  live?: string
}

/** What this plugin needs of the catalogue: wherever it holds TeX. */
interface Symbols {
  planners: {
    name: string
    parameters: { symbol: string }[]
    readings: { symbol: string }[]
    formulas: Formula[]
    pseudocode: string[]
  }[]
  drive: Follower
  motion: Follower
  /** The TeX strings that only turn up at run time. */
  symbols?: string[]
}

/**
 * Provides `virtual:formulas`: the catalogue's TeX as MathML, made while building, so that the page ships no TeX engine.
 * Symbols come at once, a planner's formulas (`virtual:formulas/wcpso`) when they are asked for.
 * @param core the folder that the wasm package was built into
 * @param texts a folder of JSON files whose texts have symbols, too
 */
export function formulas(core: string, texts: string): Plugin {
  const file = resolve(core, 'catalogue.json')

  return {
    name: 'forage-formulas',
    resolveId: (id) => (id === ID || id.startsWith(`${ID}/`) ? `\0${id}` : undefined),
    async load(id) {
      if (!id.startsWith(RESOLVED)) return undefined
      this.addWatchFile(file)
      const catalogue = await readCatalogue(file)
      const displayed = formulasOf(catalogue)
      if (id !== RESOLVED) {
        const name = id.slice(RESOLVED.length + 1)
        return [
          `export default ${JSON.stringify(typeset(displayed[name] ?? new Set(), true))}`,
          `export const inline = ${JSON.stringify(typeset(inlineOf(catalogue, name), false))}`,
        ].join('\n')
      }
      const loaders = Object.keys(displayed).map((name) => `${JSON.stringify(name)}: () => import(${JSON.stringify(`${ID}/${name}`)})`)
      return [
        `export const inline = ${JSON.stringify(typeset(new Set([...symbolsOf(catalogue), ...(await symbolsIn(texts))]), false))}`,
        `export const display = { ${loaders.join(', ')} }`,
      ].join('\n')
    },
  }
}

async function readCatalogue(file: string): Promise<Symbols> {
  const text = await readFile(file, 'utf8').catch(() => {
    throw new Error(`${file} is missing: build the core first (scripts/build-wasm)`)
  })
  return JSON.parse(text) as Symbols
}

function symbolsOf({ planners, symbols = [], ...others }: Symbols): Set<string> {
  const followers = FOLLOWERS.flatMap((name) => [...others[name].parameters, ...others[name].columns])
  const told = [...planners.flatMap(({ parameters, readings }) => [...parameters, ...readings]), ...followers]
  return new Set([...symbols, ...told.map(({ symbol }) => symbol)])
}

/** The TeX in the texts of a folder's files. */
async function symbolsIn(folder: string): Promise<string[]> {
  const names = (await readdir(folder)).filter((name) => name.endsWith('.json') && !name.endsWith('.schema.json'))
  const files = await Promise.all(names.map(async (name) => (JSON.parse(await readFile(resolve(folder, name), 'utf8')) as Texts).texts))
  const texts = files.flatMap((languages = {}) => Object.values(languages).flatMap((known) => Object.values(known)))
  return texts.flatMap((text) => [...text.matchAll(SYMBOL)].map(([, tex = '']) => tex))
}

/** The TeX in a planner's pseudocode. */
function inlineOf({ planners }: Symbols, name: string): Set<string> {
  const lines = planners.find((planner) => planner.name === name)?.pseudocode ?? []
  return new Set(lines.flatMap((line) => [...line.matchAll(/\$([^$]*)\$/g)].map(([, tex = '']) => tex)))
}

function formulasOf({ planners, ...others }: Symbols): Record<string, Set<string>> {
  const all = [...planners, ...FOLLOWERS.map((name) => ({ name, formulas: others[name].formulas }))]
  return Object.fromEntries(
    all.map(({ name, formulas }) => [name, new Set(formulas.flatMap(({ tex, live }) => (live ? [tex, live] : [tex])))]),
  )
}

function typeset(sources: Set<string>, displayMode: boolean): Record<string, string> {
  return Object.fromEntries([...sources].map((tex) => [tex, mathml(tex, displayMode)]))
}

/** Numbers that stand for `@name@` while TeX is set: spaces come out as they would around the real ones. */
const SLOT = 9_021_000
const FUNCTION =
  /(<\/(?:mi|mn|msub|msup|mfrac|mtext)>)(?=<mrow><mi>[a-z]{2,}<\/mi><mo>\u2061<\/mo>(?:<mspace[^>]*><\/mspace>)?<\/mrow>(?!<\/msu))/g
const PRIME = /<msup>(<mi>[^<]*<\/mi>)<mo [^>]*class="tml-prime[^>]*>′<\/mo><\/msup>/g

/** What math.css has for each style that the typesetter writes: under the page's policy styles in attributes do nothing. */
const CLASSES: Readonly<Record<string, string>> = {
  'math-depth:0;': 'depth-0',
  'math-depth:1;': 'depth-1',
  'math-depth:2;': 'depth-2',
  'padding-left:0em;padding-right:0em;': 'close',
  'padding-left:1em;padding-right:0em;': 'apart',
}

function classed(tag: string, attributes: string, style: string): string {
  const name = CLASSES[style]
  if (!name) throw new Error(`math.css has no class for the style ${style}`)
  const [, before] = / class="([^"]*)"/.exec(attributes) ?? []
  const rest = attributes.replace(/ class="[^"]*"/, '')
  return `<${tag}${rest} class="${before ? `${before} ` : ''}${name}"`
}

/** MathML, with every `@name@` left in it as `<mtext>@name@</mtext>`. Formulas may break after their outer operators. */
export function mathml(tex: string, displayMode: boolean): string {
  const names: string[] = []
  const source = tex.replace(/@([\w.-]+)@/g, (_, name: string) => `{${SLOT + names.push(name) - 1}}`)
  return (
    temml
      .renderToString(source, { wrap: displayMode ? 'tex' : 'none', throwOnError: true, trust: ({ command }) => command === '\\class' })
      .replace(/<mn( class="[^"]*")?>(\d{7})<\/mn>/g, (whole, term: string | undefined, digits: string) => {
        const name = names[Number(digits) - SLOT]
        const slot = `<mtext>@${name}@</mtext>`
        return name === undefined ? whole : term ? `<mrow${term}>${slot}</mrow>` : slot
      })
      .replace(FUNCTION, '$1<mspace width="0.1667em"></mspace>')
      // Text fonts have the prime where it belongs; as a superscript it would be raised twice.
      .replace(PRIME, '<mrow>$1<mo class="prime" lspace="0em" rspace="0em">′</mo></mrow>')
      // At the end of a piece an operator would count as a postfix and lose its spaces.
      .replace(/<mo>([^<]+)<\/mo><\/mrow>(?=<mrow>|<\/math>)/g, '<mo form="infix">$1</mo></mrow>')
      .replace(/^<math>/, displayMode ? '<math displaystyle="true">' : '<math>')
      .replace(/<([a-z]+)([^>]*?) style="([^"]*)"/g, (_, tag: string, attributes: string, style: string) => classed(tag, attributes, style))
  )
}
