import type { Point } from 'forage-lab'
import { forget, recall, remember } from './storage'

/** What was answered: a place on the stage, or one of the options. */
export type Guess = { point: Point } | { option: number }

/** How far a lesson was read, and what was answered in it. */
export interface Standing {
  /** The step that was read last, and the farthest one, from 0. */
  step: number
  farthest: number
  /** By the step's name: what was answered first. */
  answers: Readonly<Record<string, Guess>>
}

const KEY = 'lessons'
const BEGINNING: Standing = { step: 0, farthest: 0, answers: {} }

function read(): Record<string, Standing> {
  try {
    const kept: unknown = JSON.parse(recall(KEY) ?? '{}')
    return typeof kept === 'object' && kept !== null ? (kept as Record<string, Standing>) : {}
  } catch {
    return {}
  }
}

/** Where the reader is in each lesson. It is kept in this browser only, and can be deleted. */
class Progress {
  private all = $state.raw<Readonly<Record<string, Standing>>>(read())
  readonly any = $derived(Object.keys(this.all).length > 0)

  of(lesson: string): Standing {
    return this.all[lesson] ?? BEGINNING
  }

  begun(lesson: string): boolean {
    return this.all[lesson] !== undefined
  }

  note(lesson: string, change: Partial<Standing>): void {
    this.all = { ...this.all, [lesson]: { ...this.of(lesson), ...change } }
    remember(KEY, JSON.stringify(this.all))
  }

  /** Deletes what is kept of a lesson, or of all. */
  clear(lesson?: string): void {
    if (lesson === undefined) {
      this.all = {}
      forget(KEY)
      return
    }
    const { [lesson]: _, ...others } = this.all
    this.all = others
    remember(KEY, JSON.stringify(others))
  }
}

export const progress = new Progress()
