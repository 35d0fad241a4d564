import type { Point } from 'forage-lab'

export interface Gestures {
  /** A finger or button went down; what is answered says if it took hold of something. */
  grab(at: Point, coarse: boolean): boolean
  /** `across`: the Shift key is down. */
  drag(at: Point, across: boolean): void
  /** The hold ended; `cancelled` if it wasn't meant. */
  drop(cancelled: boolean): void
  /** `aside`: with two fingers or another button than the first. */
  pan(dx: number, dy: number, aside: boolean): void
  zoom(by: number, at: Point): void
  tap(at: Point, coarse: boolean): void
  hover(at: Point | null): void
}

/** Below this a press is a tap, not a drag. */
const SLACK = 4
const WHEEL = 0.0016

/** Turns pointer and wheel events of an element into gestures. `scale`: pixels of the page one of theirs takes. */
export function gestures(element: HTMLElement, act: Gestures, scale: () => number = () => 1): () => void {
  const fingers = new Map<number, Point>()
  let holding = false
  /** Only the first button takes hold and taps; the others move the view. */
  let first = true
  let moved = false
  let origin: Point = [0, 0]

  const where = (event: MouseEvent): Point => {
    const { left, top } = element.getBoundingClientRect()
    return [(event.clientX - left) / scale(), (event.clientY - top) / scale()]
  }

  const down = (event: PointerEvent): void => {
    if (event.button > 2) return
    const at = where(event)
    element.setPointerCapture(event.pointerId)
    fingers.set(event.pointerId, at)
    if (fingers.size === 1) {
      origin = at
      moved = false
      first = event.button === 0
      holding = first && act.grab(at, event.pointerType !== 'mouse')
    } else if (holding) {
      holding = false
      act.drop(true)
    }
    if (fingers.size > 1) moved = true
  }

  const move = (event: PointerEvent): void => {
    const at = where(event)
    const before = fingers.get(event.pointerId)
    if (!before) {
      act.hover(at)
      return
    }
    if (!moved && Math.hypot(at[0] - origin[0], at[1] - origin[1]) < SLACK) return
    moved = true
    fingers.set(event.pointerId, at)
    if (holding) {
      act.drag(at, event.shiftKey)
      return
    }
    const other = [...fingers].find(([id]) => id !== event.pointerId)?.[1]
    if (!other) {
      act.pan(at[0] - before[0], at[1] - before[1], !first)
      return
    }
    act.pan((at[0] - before[0]) / 2, (at[1] - before[1]) / 2, true)
    const span = (to: Point): number => Math.max(1, Math.hypot(to[0] - other[0], to[1] - other[1]))
    act.zoom(span(at) / span(before), [(at[0] + other[0]) / 2, (at[1] + other[1]) / 2])
  }

  const up = (event: PointerEvent): void => {
    if (!fingers.delete(event.pointerId)) return
    const cancelled = event.type === 'pointercancel'
    if (holding) act.drop(cancelled || !moved)
    if (!moved && !cancelled && first && fingers.size === 0) act.tap(where(event), event.pointerType !== 'mouse')
    holding = false
  }

  // A finger leaves after each tap.
  const leave = (event: PointerEvent): void => {
    if (fingers.size === 0 && event.pointerType === 'mouse') act.hover(null)
  }

  const wheel = (event: WheelEvent): void => {
    event.preventDefault()
    const unit = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1
    act.zoom(Math.exp(-event.deltaY * unit * WHEEL * (event.ctrlKey ? 5 : 1)), where(event))
  }

  const abort = new AbortController()
  const { signal } = abort
  element.addEventListener('pointerdown', down, { signal })
  element.addEventListener('pointermove', move, { signal })
  element.addEventListener('pointerup', up, { signal })
  element.addEventListener('pointercancel', up, { signal })
  element.addEventListener('pointerleave', leave, { signal })
  element.addEventListener('contextmenu', (event) => event.preventDefault(), { signal })
  element.addEventListener('wheel', wheel, { signal, passive: false })
  return () => abort.abort()
}
