import type { Questions } from '../engine/host/questions'
import type { Answer, Refusal } from '../engine/protocol'
import { Gone, type RunClient } from '../engine/run-client'
import { common } from '../locales/en/common'

/** What a question came to; null if the thread broke down. */
export const unlessGone = (error: unknown): null => {
  if (!(error instanceof Gone)) throw error
  return null
}

const isUnloaded = (answer: unknown): answer is { ok: false; refusal: Refusal } =>
  typeof answer === 'object' && answer !== null && (answer as Partial<Extract<Answer<unknown>, { ok: false }>>).refusal?.unloaded === true

/** A refusal as it is shown: where a part could not be loaded, the reason is the browser's. */
export const worded = (refusal: Refusal): Refusal =>
  refusal.unloaded ? { ...refusal, message: common.notices.unloaded(refusal.message) } : refusal

/** For questions to the run. A refusal says in the page's words that a part could not be loaded. */
export const questionsTo = (client: RunClient, codeFor: (link: string) => string | undefined): Questions =>
  new Proxy({} as Questions, {
    get:
      (_, name: string) =>
      async (...given: unknown[]) => {
        const questions = client.api as unknown as Record<string, (...given: unknown[]) => Promise<unknown>>
        // What a link names may be a planner that somebody wrote here.
        const all = name === 'parseLink' ? [given[0], given[1] ?? codeFor(given[0] as string)] : given
        const answer = await questions[name]?.(...all)
        return isUnloaded(answer) ? { ...answer, refusal: worded(answer.refusal) } : answer
      },
  })
