/* The worker of a WorkerSession, in Node. */
import { expose } from 'comlink'
import nodeEndpoint from 'comlink/dist/esm/node-adapter.mjs'
import { parentPort } from 'node:worker_threads'
import { freed } from './glue.js'
import * as forage from './node.js'
import { host } from './session-host.js'

expose(host({ ...forage, freed, isolate: () => import('./isolate.node.js') }), nodeEndpoint(parentPort))
