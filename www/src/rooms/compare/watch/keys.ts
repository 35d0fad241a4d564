interface Acts {
  toggle(): void
  /** By notches. */
  step(by: number): void
  begin(): void
  end(): void
}

interface Moves {
  zoom(by: number): void
  pan(dx: number, dy: number): void
  fit(): void
}

const PAN = 40

const modified = ({ ctrlKey, metaKey, altKey }: KeyboardEvent): boolean => ctrlKey || metaKey || altKey

/** Whether a key belongs to what has the focus: fields and choosers use arrows, and buttons the space bar. */
function taken({ target, key }: KeyboardEvent, timeline: HTMLElement | undefined): boolean {
  if (!(target instanceof HTMLElement) || target === timeline) return false
  if (target.isContentEditable || target.matches('input, select, textarea, [role=slider]') || target.closest('dialog')) return true
  return key === ' ' && target.matches('button, summary, a')
}

/** The race's time, as on the stage: space, arrows, Home and End; true if a key did something. */
export function timeKey(event: KeyboardEvent, timeline: HTMLElement | undefined, acts: Acts): boolean {
  if (modified(event) || taken(event, timeline)) return false
  const far = event.shiftKey ? 10 : 1
  const known: Readonly<Record<string, () => void>> = {
    ' ': acts.toggle,
    ArrowLeft: () => acts.step(-far),
    ArrowRight: () => acts.step(far),
    Home: acts.begin,
    End: acts.end,
  }
  const act = known[event.key]
  act?.()
  return act !== undefined
}

/** The view of all lanes, from a lane's picture. */
export function viewKey(event: KeyboardEvent, moves: Moves): boolean {
  if (modified(event)) return false
  const known: Readonly<Record<string, () => void>> = {
    '+': () => moves.zoom(1.25),
    '=': () => moves.zoom(1.25),
    '-': () => moves.zoom(0.8),
    '0': moves.fit,
    ArrowUp: () => moves.pan(0, PAN),
    ArrowDown: () => moves.pan(0, -PAN),
  }
  const act = known[event.key]
  act?.()
  return act !== undefined
}
