/* The graph of imports of the page's sources. */
import { readdirSync, readFileSync } from 'node:fs'
import { dirname, join, normalize } from 'node:path'

/** The folders of `src`, low to high: a file imports only files of its own folder and of those above it in this list. */
export const ORDER = [
  'locales',
  'text',
  'scene',
  'catalogue',
  'lessons',
  'render',
  'engine',
  'ui',
  'stores',
  'features',
  'rooms',
  'hosts',
] as const

/** The files that each file imports; paths are relative to the sources' root. */
export type Graph = ReadonlyMap<string, ReadonlySet<string>>

/** `from '…'`, `import '…'`, `import('…')`, `new URL('…', …)` and `typeof import('…')` with a relative path. */
const IMPORT = /(?:\bfrom|\bimport|\bnew URL)\s*\(?\s*'(\.{1,2}\/[^'?]+)/g
const ENDINGS = ['', '.ts', '.svelte', '.d.ts']

/** Reads all sources below `root` but their tests. Imports of types and dynamic ones count. */
export function graphOf(root: string): Graph {
  const files = readdirSync(root, { recursive: true, encoding: 'utf8' }).filter(
    (file) => /\.(ts|svelte|css)$/.test(file) && !file.endsWith('.test.ts'),
  )
  const known = new Set(files)
  const resolve = (from: string, to: string): string => {
    const path = normalize(join(dirname(from), to))
    const found = ENDINGS.map((ending) => path + ending).find((file) => known.has(file))
    if (!found) throw new Error(`${from} imports ${to}, which does not exist`)
    return found
  }
  return new Map(
    files.sort().map((file) => {
      // Data leads nowhere.
      const imports = [...readFileSync(join(root, file), 'utf8').matchAll(IMPORT)]
        .map(([, to = '']) => to)
        .filter((to) => !to.endsWith('.json'))
      return [file, new Set(imports.map((to) => resolve(file, to)))]
    }),
  )
}

const rank = (file: string): number => ORDER.findIndex((folder) => file.startsWith(`${folder}/`))

/** Imports of files that lie higher, as `from → to`. */
export function upward(graph: Graph): string[] {
  return [...graph].flatMap(([from, imports]) => [...imports].filter((to) => rank(to) > rank(from)).map((to) => `${from} → ${to}`))
}

/** Sets of files that lead to each other (Tarjan's algorithm). */
export function circles(graph: Graph): string[][] {
  const [index, low, stack, found]: [Map<string, number>, Map<string, number>, string[], string[][]] = [new Map(), new Map(), [], []]
  const visit = (file: string): void => {
    index.set(file, index.size)
    low.set(file, index.get(file) ?? 0)
    stack.push(file)
    for (const to of graph.get(file) ?? []) {
      if (!index.has(to)) visit(to)
      if (stack.includes(to)) low.set(file, Math.min(low.get(file) ?? 0, low.get(to) ?? 0))
    }
    if (low.get(file) !== index.get(file)) return
    const circle = stack.splice(stack.indexOf(file))
    if (circle.length > 1) found.push(circle.sort())
  }
  for (const file of graph.keys()) if (!index.has(file)) visit(file)
  return found
}
