import type { Attachment } from 'svelte/attachments'

/** How the terms of a formula look that marks on the stage stand for, and who hears of it when one is pointed at. */
export interface Terms {
  /** Colours by the layers of the marks. */
  colours: Readonly<Record<string, string>>
  /** The layer that stands out. */
  lit: string | null
  onpoint(role: string | null): void
}

/** Gives each term of a formula the colour of its mark. */
export const coloured =
  (html: string | undefined, terms: Terms | undefined): Attachment<HTMLElement> =>
  (node) => {
    if (!terms || html === undefined) return
    for (const [role, colour] of Object.entries(terms.colours)) {
      for (const term of node.querySelectorAll<HTMLElement>(`math .${CSS.escape(role)}`)) {
        term.style.setProperty('--term', colour)
        term.classList.add('term')
        term.classList.toggle('lit', terms.lit === role)
      }
    }
  }

/** The layer whose term is there. */
export function termAt({ target }: Event, { colours }: Terms): string | null {
  const term = target instanceof Element ? target.closest('.term') : null
  return Object.keys(colours).find((role) => term?.classList.contains(role)) ?? null
}
