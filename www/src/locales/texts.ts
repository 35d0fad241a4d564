/* Texts by name, in the language of the page. What is read in a component is read again when the language changes. */

/** A module of texts in another language: the same names, and any words. */
export type Translated<T> = T extends string
  ? string
  : T extends (...given: infer Given) => string
    ? (...given: Given) => string
    : { readonly [K in keyof T]: Translated<T[K]> }

type Node = Readonly<Record<string, unknown>>

/** What another language has of a module; nothing for English. */
let translation: (module: string) => Node | undefined = () => undefined

/** Sets where texts come from. */
export function translateBy(source: typeof translation): void {
  translation = source
}

const isNode = (value: unknown): value is Node =>
  typeof value === 'object' && value !== null && Object.getPrototypeOf(value) === Object.prototype

function view(english: Node, translated: () => Node | undefined): Node {
  const inner = new Map<PropertyKey, Node>()
  return new Proxy(english, {
    get(_, key) {
      const own: unknown = Reflect.get(english, key)
      const of = (node: Node | undefined): unknown => (node ? Reflect.get(node, key) : undefined)
      if (!isNode(own)) return of(translated()) ?? own
      const known = inner.get(key)
      if (known) return known
      const made = view(own, () => of(translated()) as Node | undefined)
      inner.set(key, made)
      return made
    },
  })
}

/** The texts of a module in the language of the page: those of English where it has none. */
export const texts = <T extends object>(module: string, english: T): T => view(english as unknown as Node, () => translation(module)) as T
