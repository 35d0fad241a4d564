import type { Attachment } from 'svelte/attachments'

/** Letters that need no setting. */
const PLAIN = /^[\p{L}\p{N} ]*$/u

/** Sets TeX that was not known while the page was built. It becomes elements, never markup: somebody may have sent it. */
export const typeset =
  (tex: string, displayMode: boolean): Attachment<HTMLElement> =>
  (node) => {
    if (PLAIN.test(tex)) return undefined
    let gone = false
    void import('temml').then(({ default: temml }) => {
      if (gone) return
      const set = document.createElement('span')
      try {
        temml.render(tex, set, { displayMode, trust: false, throwOnError: true })
        node.replaceChildren(set)
      } catch {
        // It stays as it was written.
      }
    })
    return () => {
      gone = true
    }
  }
