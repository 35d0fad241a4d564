/** Made while building, by plugins/inlined.ts. */
declare module 'virtual:inlined' {
  /** The scripts of threads, by what a host calls them. */
  export const threads: Readonly<Record<'run' | 'trial' | 'render', string>>
  /** The package's files by name, compressed by gzip and in base64. */
  export const files: Readonly<Record<string, string>>
}
