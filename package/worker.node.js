/* For Node: WorkerSession in one of its threads. */
import nodeEndpoint from 'comlink/dist/esm/node-adapter.mjs'
import { Worker } from 'node:worker_threads'
import { sessionIn } from './worker-session.js'

export { ModuleDead } from './guard.js'

// How the program was called (an evaluated text, a loader) means nothing to it.
export const WorkerSession = sessionIn((given) => {
  const worker = given ?? new Worker(new URL('./session-worker.node.js', import.meta.url), { execArgv: [] })
  const failed = (tell) => {
    for (const event of ['error', 'messageerror']) worker.on(event, tell)
    worker.on('exit', (code) => tell(new Error(`it ended with code ${code}`)))
  }
  return { worker, endpoint: nodeEndpoint(worker), failed }
})
