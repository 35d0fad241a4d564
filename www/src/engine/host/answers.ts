import { ModuleDead } from 'forage-lab/core'
import type { Answer } from '../protocol'
import { causeOf, refusalOf } from './refusal'
import { rest } from './rest'

/** What the core says; a part of it that is needed for that is loaded first, and the words for it. Fails if the core breaks down. */
export async function answer<T>(ask: () => T): Promise<Answer<T>> {
  try {
    return { ok: true, value: await (await rest()).ready(ask) }
  } catch (error) {
    if (error instanceof ModuleDead) throw error
    return { ok: false, refusal: refusalOf(error) ?? { message: causeOf(error), field: '', unloaded: true } }
  }
}

/** The same of what has words only when it is refused: they are loaded then. */
export async function silently<T>(ask: () => T): Promise<Answer<T>> {
  try {
    return { ok: true, value: ask() }
  } catch {
    return answer(ask)
  }
}
