/* For pages and bundlers: WorkerSession in a worker of the page. */
import { sessionIn } from './worker-session.js'

export { ModuleDead } from './guard.js'

export const WorkerSession = sessionIn((given) => {
  const worker = given ?? new Worker(new URL('./session-worker.js', import.meta.url), { type: 'module' })
  const failed = (tell) => {
    for (const event of ['error', 'messageerror']) worker.addEventListener(event, tell)
  }
  return { worker, endpoint: worker, failed }
})
