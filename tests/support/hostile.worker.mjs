// The thread of hostile.html: what does not mean well runs here.
import { registerCode } from '../../pkg/isolate.js'
import { ready, Session } from '../../pkg/page.js'
import { attack } from '../hostile.mjs'

await ready(() => new Session({ planner: 'pso', scene: 'sphere-2' }).free())
postMessage(JSON.stringify(await attack({ registerCode, Session })))
