declare module 'virtual:lessons' {
  import type { Lesson } from '../../lessons/format'

  interface Entry {
    name: string
    kind: 'lesson' | 'article'
    minutes?: number
    paper?: string
    steps: number
    language: string
    texts: Readonly<Record<string, { title: string; summary: string }>>
  }

  /** The claims that lessons name, as they are judged. */
  export const claims: Readonly<Record<string, { paper: string; says: string; mark: import('../papers/claims').ClaimMark }>>
  /** What there is, in its order. */
  export const entries: readonly Entry[]
  export const load: Readonly<Record<string, () => Promise<{ default: Lesson }>>>
}
