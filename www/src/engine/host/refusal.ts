import { ModuleDead } from 'forage-lab/core'
import type { Refusal } from '../protocol'

/** What went wrong, in short: of a module that broke down, how. */
export function causeOf(error: unknown): string {
  const cause = error instanceof ModuleDead ? error.cause : error
  return cause instanceof Error ? cause.message : String(cause)
}

/** What the core refuses, as plain data. Undefined for other errors: the core's have a code, those of the network have none. */
export function refusalOf(error: unknown): Refusal | undefined {
  if (error instanceof ModuleDead || !(error instanceof Error) || !('code' in error)) return undefined
  const { field, line, column, stopped } = error as Partial<Refusal>
  return {
    message: error.message,
    field: typeof field === 'string' ? field : '',
    ...(typeof line === 'number' && { line }),
    ...(typeof column === 'number' && { column }),
    ...(stopped && { stopped }),
  }
}
