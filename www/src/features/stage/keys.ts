import type { Clock } from '../../stores/clock.svelte'
import type { Lab } from '../../stores/lab.svelte'

interface Acts {
  zoom(by: number): void
  fit(): void
  pan(dx: number, dy: number): void
  /** Moves the selected object by steps. */
  nudge(dx: number, dy: number): void
  /** Of what moves by itself: makes it faster that way. */
  aim(dx: number, dy: number): void
  /** Where cells are painted or asked about: moves the cell that is meant; rows count from the top. */
  walk?(columns: number, rows: number): void
  /** Paints or erases it, or looks closer. */
  act?(): void
  leave(): void
}

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
}
const PAN = 40

/** While there is another time beside the run's, keys are for that. */
export function clockKey(event: KeyboardEvent, clock: Clock, leave: () => void): boolean {
  if (event.ctrlKey || event.metaKey || event.altKey) return false
  const far = event.shiftKey ? 10 : 1
  const acts: Readonly<Record<string, () => void>> = {
    ' ': clock.toggle,
    ArrowLeft: () => clock.seek(Math.ceil(clock.time) - far),
    ArrowRight: () => clock.seek(Math.floor(clock.time) + far),
    Home: () => clock.seek(0),
    End: () => clock.seek(clock.end),
    Escape: leave,
  }
  const act = acts[event.key]
  act?.()
  return act !== undefined
}

/** What a key does on the stage; true if it did something. Arrows move the selected object, otherwise the time. */
export function stageKey(lab: Lab, event: KeyboardEvent, acts: Acts): boolean {
  if (event.ctrlKey || event.metaKey || event.altKey) return false
  const arrow = ARROWS[event.key]
  if (arrow) {
    const [dx, dy] = arrow
    const far = event.shiftKey ? 10 : 1
    if (acts.walk) acts.walk(dx * far, -dy * far)
    else if (lab.selection.object?.kind === 'moving' && event.shiftKey) acts.aim(dx, dy)
    else if (lab.selection.object) acts.nudge(dx * far, dy * far)
    else if (dy !== 0) acts.pan(0, dy * PAN)
    else lab.playback.stepBy(dx * far)
    return true
  }
  switch (event.key) {
    case ' ':
      if (acts.act) acts.act()
      else lab.playback.toggle()
      return true
    case 'Home':
      lab.playback.seek(0)
      return true
    case 'End':
      lab.playback.seek(Infinity)
      return true
    case '+':
    case '=':
      acts.zoom(1.25)
      return true
    case '-':
      acts.zoom(0.8)
      return true
    case '0':
      acts.fit()
      return true
    case 'Delete':
    case 'Backspace':
      lab.scene.removeSelected()
      return true
    case 'Escape':
      acts.leave()
      return true
    default:
      return false
  }
}
