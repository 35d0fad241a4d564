import { type Remote, wrap } from 'comlink'
import type { Finding, Reachability, Scene } from 'forage-lab'
import { carryOut } from 'forage-lab/core'
import type { Answer } from '../protocol'
import type { Errand, Hand } from './subtasks'
import { breathe } from './pace'
import { rest } from './rest'

/** What is asked of a thread by another one. */
interface Api {
  carryOut(errand: Errand): Promise<Finding>
  survey(scene: Scene, step: number): Promise<Answer<Reachability>>
}

interface Other {
  api: Remote<Api>
  failed: Promise<never>
  end(): void
}

/** Another thread with the same code and a core of its own. */
export function other(): Other {
  const worker = new Worker(self.location.href, { type: 'module' })
  const failed = new Promise<never>((_, reject) => {
    worker.onerror = (event) => {
      event.preventDefault()
      reject(new Error(event.message))
    }
  })
  return { api: wrap<Api>(worker), failed, end: () => worker.terminate() }
}

/** One that carries out runs. */
export function thread(): Hand {
  const { api, failed, end } = other()
  return { carryOut: (errand) => Promise.race([api.carryOut(errand), failed]), dismiss: end }
}

/** This thread, which listens between two runs. */
export const oneself: Hand = {
  async carryOut(errand) {
    await breathe()
    return (await rest()).ready(() => carryOut(errand))
  },
  dismiss() {},
}
