declare module 'virtual:languages' {
  /** The languages of the page, as each calls itself, and in a letter or two. */
  export const languages: readonly { readonly tag: string; readonly name: string; readonly sign: string }[]
  export interface Words {
    /** Those of them that the first view has. */
    first(): Promise<Readonly<Record<string, object>>>
    /** The texts of the page by the modules of English. */
    texts(): Promise<Readonly<Record<string, object>>>
    /** Those of the catalogue, in its order. */
    catalogue(): Promise<readonly string[]>
    /** How what `forage reproduce` wrote is said. */
    report(): Promise<Readonly<Record<string, string>>>
  }
  export const load: Readonly<Record<string, Words>>
}
