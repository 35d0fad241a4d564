/*
 * What the glue does around the module's functions. A call that traps (out of memory, out of stack, a panic) leaves the module's
 * memory in a state that nobody knows: no later call may go there. And objects that are freed, or of an instance that was
 * replaced, say so by name.
 */

const freedOnes = new WeakSet()
let dead
let sayDead

/** What every call throws after one broke down, until `reset()`; `cause` is how it did. */
export class ModuleDead extends Error {
  constructor(cause) {
    const values = { cause: String(cause) }
    super(sayDead?.('error-module-dead', values) ?? 'error-module-dead', { cause })
    this.name = 'ModuleDead'
    this.code = 'module-dead'
  }
}

/** How it is said that the module is dead: it cannot say so by itself. */
export function sayDeadBy(say) {
  sayDead = say
}

/** What the glue throws before it has done anything, where a getter or a function of the caller's uses the object that is being used. */
const refusesReuse = (cause) => cause instanceof Error && /recursive use of an object|while it was borrowed/.test(cause.message)

/** The exports of an instance, until a call of one of them does not return. */
export function guarded(exports) {
  dead = undefined
  const items = Object.entries(exports)
  return Object.fromEntries(items.map(([name, item]) => [name, typeof item === 'function' ? guard(item, name.endsWith('free')) : item]))
}

function guard(call, frees) {
  return (...given) => {
    if (dead === undefined) {
      try {
        return call(...given)
      } catch (cause) {
        if (refusesReuse(cause)) throw cause
        dead ??= new ModuleDead(cause)
      }
    } else if (frees) return
    throw dead
  }
}

/** Marks an object as freed: its address is asked for by whoever calls a method. */
export function leave(object, refuse) {
  freedOnes.add(object)
  Object.defineProperty(object, '__wbg_ptr', {
    get() {
      throw refuse(false)
    },
  })
}

/** Whether there is nothing to free: an address in memory that was replaced means nothing. */
export const isGone = (object, instance) => freedOnes.has(object) || object.__wbg_inst !== instance

/** Refuses an object of an instance that was replaced. */
export function mustBeOf(object, instance, refuse) {
  if (!freedOnes.has(object) && object.__wbg_inst !== instance) throw refuse(true)
}
