/** Made by plugins/reproduction.ts of what `forage reproduce` wrote. */
declare module 'virtual:reproduction' {
  /** The published figures beside ours. */
  export const rows: readonly import('./row').Row[]
  /** What the papers claim, and whether it holds here. */
  export const checks: readonly import('./row').Check[]
}
