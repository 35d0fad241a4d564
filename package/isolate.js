import { registerCodeBy } from './interpreter.js'
import { compiled, load } from './page.js'
import { interpreter } from './parts.js'

export { codeIn, withCode } from './own/link.js'
export { mathematics, stateOf } from './own.js'
export { powerBy, withPowers } from '../crates/isolate/src/js/powers.js'
export { shown } from '../crates/isolate/src/js/shown.js'

/** Adds a planner by its code, which runs in an interpreter of its own. */
export const registerCode = (code, { onprint } = {}) =>
  registerCodeBy(code, { compiled: () => compiled('interpreter', interpreter), loadCode: () => load('code'), onprint })
