import { ModuleDead } from 'forage-lab/core'

/** What went wrong, in short: of a module that broke down, how. */
export function causeOf(error: unknown): string {
  const cause = error instanceof ModuleDead ? error.cause : error
  return cause instanceof Error ? cause.message : String(cause)
}
