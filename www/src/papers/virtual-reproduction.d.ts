/** Made by plugins/reproduction.ts: the published figures beside ours, as `forage reproduce` wrote them. */
declare module 'virtual:reproduction' {
  export const rows: readonly import('./row').Row[]
}
