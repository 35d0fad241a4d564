declare module 'virtual:templates' {
  /** Each template by its name, and what it is in each language. */
  export const templates: Readonly<Record<string, Readonly<Record<string, { readonly title: string; readonly code: string }>>>>
}
