/*
 * Planners in JavaScript: what an author writes becomes a planner like any other.
 */
import { lent, lentList, registerPlanner } from './glue.js'
import { afterReset, holdersOf } from './loader.js'
import { describe, refused } from '../crates/isolate/src/js/describe.js'
import { hostOf, mathBy } from '../crates/isolate/src/js/host.js'

export { describe }

/** What was added last, by name. */
const known = new Map()
/** The state that was asked for its hash last, and its host. */
let seen

/** What a restarted module is given again. */
function again() {
  for (const { described, host } of known.values()) registerPlanner(described, host)
}

/** A host that is let go, and with it an interpreter, when another one has come and its last state is forgotten: the module keeps its shell. */
function held(host) {
  let states = 0
  let replaced = false
  const shell = {
    ...host,
    digest(id) {
      seen = { host, id }
      return host.digest(id)
    },
    start(...given) {
      const id = host.start(...given)
      states += 1
      return id
    },
    copy(id) {
      const copied = host.copy(id)
      states += 1
      return copied
    },
    forget(id) {
      try {
        host.forget(id)
      } finally {
        states -= 1
        letGo()
      }
    },
  }
  function letGo() {
    if (replaced && states === 0) for (const name of Object.keys(shell)) delete shell[name]
  }
  const replace = () => {
    replaced = true
    letGo()
  }
  return { host: shell, replace }
}

/** Adds a planner to those that are known. `given`: who calls its code; `described`: what it says of itself. */
export function add(described, given) {
  if (holdersOf('planner', described.name)) throw refused('name', described.name, 'a name that no planner of the package has')
  const { host, replace } = held(given)
  registerPlanner(described, host)
  if (known.size === 0) afterReset(again)
  known.get(described.name)?.replace()
  known.set(described.name, { described, host, replace })
  return described
}

/** `Math` for code of planners. */
export const mathematics = mathBy(lent)

/** What a planner says of itself that was added by its name. */
export function describedBy(name) {
  const found = known.get(name)
  if (!found) throw refused('planner', name, 'the name of a planner that was registered')
  return found.described
}

/** The state of a session's planner, if somebody wrote that planner. */
export function stateOf(session) {
  seen = undefined
  // What is asked for its hash is the present state.
  session.hash()
  return seen?.host.state(seen.id)
}

/** Adds a planner whose code runs in this thread. `load` loads the part of the module that runs such planners. */
export async function register(planner, load) {
  const described = describe(planner)
  await load('code')
  const layers = described.layers.map(({ role }) => role)
  return add(described, hostOf(planner, layers, { lent, lentList }))
}
