import { createContext } from 'svelte'
import type { Lab } from './lab.svelte'

/** The lab that a component belongs to: of several on a page each has its own. */
export const [useLab, provideLab] = createContext<Lab>()

/** What there is once for each lab, made when it is first asked for. */
export function perLab<T extends object>(make: (lab: Lab) => T): (lab: Lab) => T {
  const made = new WeakMap<Lab, T>()
  return (lab) => {
    const known = made.get(lab)
    if (known) return known
    // It outlives the component that asks first.
    let fresh!: T
    $effect.root(() => {
      fresh = make(lab)
    })
    made.set(lab, fresh)
    return fresh
  }
}
