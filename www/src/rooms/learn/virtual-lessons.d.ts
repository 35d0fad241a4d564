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

  /** What there is, in its order. */
  export const entries: readonly Entry[]
  export const load: Readonly<Record<string, () => Promise<{ default: Lesson }>>>
}
