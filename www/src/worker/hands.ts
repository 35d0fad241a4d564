import { wrap } from 'comlink'
import { carryOut } from 'forage'
import type { Hand } from './crew'
import { breathe } from './pace'
import type { Api } from './sim.worker'

/** Another thread with the same code and a core of its own. */
export function thread(): Hand {
  const worker = new Worker(self.location.href, { type: 'module' })
  const remote = wrap<Api>(worker)
  const failed = new Promise<never>((_, reject) => {
    worker.onerror = (event) => {
      event.preventDefault()
      reject(new Error(event.message))
    }
  })
  return { carryOut: (errand) => Promise.race([remote.carryOut(errand), failed]), dismiss: () => worker.terminate() }
}

/** This thread, which listens between two runs. */
export const oneself: Hand = {
  async carryOut(errand) {
    await breathe()
    return carryOut(errand)
  },
  dismiss() {},
}
