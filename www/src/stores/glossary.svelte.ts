/** The glossary: whether it is open, and at which term. */
class GlossaryStore {
  /** In English; an empty one: at its beginning; null: it is closed. */
  term = $state<string | null>(null)

  readonly open = (term = ''): void => {
    this.term = term
  }

  readonly close = (): void => {
    this.term = null
  }
}

export const glossary = new GlossaryStore()
