/** Made by contract.ts of the package's planner.d.ts. */
declare module 'virtual:contract' {
  export type Member = import('./contract').Member
  /** The members of each interface. */
  export const contract: Readonly<Record<string, readonly Member[]>>
}
