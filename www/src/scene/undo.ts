/** Undo and redo of values that are never changed in place. */
export interface History<T> {
  past: readonly T[]
  present: T
  future: readonly T[]
}

const DEPTH = 200

export function begin<T>(present: T): History<T> {
  return { past: [], present, future: [] }
}

export function commit<T>({ past, present }: History<T>, next: T): History<T> {
  return { past: [...past, present].slice(-DEPTH), present: next, future: [] }
}

export function undo<T>(history: History<T>): History<T> {
  const previous = history.past.at(-1)
  if (previous === undefined) return history
  return { past: history.past.slice(0, -1), present: previous, future: [history.present, ...history.future] }
}

export function redo<T>(history: History<T>): History<T> {
  const [next, ...future] = history.future
  if (next === undefined) return history
  return { past: [...history.past, history.present], present: next, future }
}

/** The present takes another form; the step that led to it stays one. */
export const amend = <T>({ past }: History<T>, present: T): History<T> => ({ past, present, future: [] })
