// A run in Node, from the package that `scripts/build-wasm` makes: `node examples/node.mjs`.
import { Session, catalogue } from '../pkg/node.js'

const session = new Session({ planner: 'wcpso', scene: 'wcpso-discs', params: { population: 60 }, seed: 1 })
while (session.status === 'running') session.step(50)
const { length, gap, feasible, hash } = session.outcome()
console.log(`${catalogue().planners.length} planners; length ${length}, gap ${gap}, feasible ${feasible}, hash ${hash}`)
session.seek(37) // any iteration, exactly
console.log(session.readings().w, session.inspect({ role: 'particles', index: 12 }).summary)
session.free()
