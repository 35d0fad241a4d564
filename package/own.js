/*
 * Planners in JavaScript: what an author writes becomes a planner like any other.
 */
import { lent, lentList, registerPlanner } from './glue.js'
import { holdersOf } from './loader.js'
import { describe, refused } from '../crates/isolate/src/js/describe.js'
import { hostOf } from '../crates/isolate/src/js/host.js'

export { describe }

/** Adds a planner to those that are known. `host`: who calls its code, if not this thread; `described`: what it says of itself. */
export function add(described, host) {
  if (holdersOf('planner', described.name)) throw refused('name', described.name, 'a name that no planner of the package has')
  registerPlanner(described, host)
  return described
}

/** Adds a planner whose code runs in this thread. `load` loads the part of the module that runs such planners. */
export async function register(planner, load) {
  const described = describe(planner)
  await load('code')
  const layers = described.layers.map(({ role }) => role)
  return add(described, hostOf(planner, layers, { lent, lentList }))
}
