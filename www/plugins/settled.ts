import type { Plugin } from 'vite'

const FILE = /svelte\/src\/internal\/client\/dom\/blocks\/await\.js$/
/** Where a block begins to write what its promise has settled to, and where that has ended. */
const [BEGIN, END] = ['restore(false);', 'unset_context(false);']

/**
 * An `{#await}` of Svelte 5.57 writes what its promise has settled to while no effect runs. Such writes go into a list that only effects
 * clear, so the list would keep every value, with all that was shown of it. After this the list is what it was before.
 */
export function settled(): Plugin {
  let isMended = false
  return {
    name: 'forage-settled',
    apply: 'build',
    transform(code, id) {
      if (!FILE.test(id)) return undefined
      for (const part of [BEGIN, END])
        if (code.split(part).length !== 2)
          throw new Error(`{#await} of this version of Svelte is written otherwise: there is no single ${part}`)
      const kept = code.replace(BEGIN, `const writes = untracked_writes; ${BEGIN}`).replace(END, `${END} set_untracked_writes(writes);`)
      isMended = true
      return { code: `import { set_untracked_writes, untracked_writes } from '../../runtime.js';\n${kept}`, map: null }
    },
    buildEnd(error) {
      if (!error && !isMended) throw new Error('{#await} of this version of Svelte is in another file')
    },
  }
}
