// The thread of hostile.html: what does not mean well runs here.
import { registerCode } from '../../pkg/isolate.js'
import { ready, Session } from '../../pkg/page.js'
import { attack } from '../hostile.mjs'

await ready(() => new Session({ planner: 'pso', scene: 'sphere-2' }).free())
const found = await attack({ registerCode, Session, ontry: (trying) => postMessage({ trying: trying.slice(0, 300) }) })
postMessage({ attacked: JSON.stringify(found) })
