/** Made by plugins/reproduction.ts of what `forage reproduce` wrote. */
declare module 'virtual:reproduction' {
  /** The published figures and the computed ones. */
  export const rows: readonly import('./row').Row[]
  /** The papers, as they print their titles. */
  export const papers: readonly import('./claims').PaperInfo[]
  /** What they claim, and what the runs say. */
  export const claims: readonly import('./claims').Claim[]
}
