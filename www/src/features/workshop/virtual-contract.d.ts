/** Made by plugins/contract.ts of the package's planner.d.ts. */
declare module 'virtual:contract' {
  export interface Member {
    name: string
    type: string
    help: string
    call: boolean
    optional: boolean
  }
  /** The members of each interface. */
  export const contract: Readonly<Record<string, readonly Member[]>>
}
