import { ModuleDead } from 'forage-lab/core'
import type { Answer } from '../protocol'
import { causeOf, refusalOf } from './refusal'
import { rest } from './rest'

/** What some work comes to. Fails if the core breaks down. */
export async function within<T>(work: () => T | Promise<T>): Promise<Answer<T>> {
  try {
    return { ok: true, value: await work() }
  } catch (error) {
    if (error instanceof ModuleDead) throw error
    return { ok: false, refusal: refusalOf(error) ?? { message: causeOf(error), field: '', unloaded: true } }
  }
}

/** What the core says; a part of it that is needed for that is loaded first, and the words for it. Fails if the core breaks down. */
export async function answer<T>(ask: () => T): Promise<Answer<T>> {
  return within(async () => (await rest()).ready(ask))
}

/** The same of what has words only when it is refused: they are loaded then. */
export async function silently<T>(ask: () => T): Promise<Answer<T>> {
  try {
    return { ok: true, value: ask() }
  } catch {
    return answer(ask)
  }
}
