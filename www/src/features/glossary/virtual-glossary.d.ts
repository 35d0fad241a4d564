declare module 'virtual:glossary' {
  /** What a term is called, and what it means, by language. */
  type Said = Readonly<Record<string, readonly [term: string, meaning: string]>>
  export const chapters: readonly { readonly said: Said; readonly terms: readonly { readonly symbol: string; readonly said: Said }[] }[]
}
