/* The worker of a WorkerSession, in a page. */
import { expose } from 'comlink'
import { freed } from './glue.js'
import * as forage from './page.js'
import { host } from './session-host.js'

expose(host({ ...forage, freed, isolate: () => import('./isolate.js') }))
