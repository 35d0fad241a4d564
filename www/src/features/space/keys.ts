import type { Lab } from '../../stores/lab.svelte'
import type { PointerController } from './pointer.svelte'
import type { Orbit, Side } from '../../render/space/orbit'

interface Acts {
  lab: Lab
  pointer: PointerController
  orbit: Orbit
  turn(azimuth: number, elevation: number): void
  zoom(by: number): void
  fit(): void
  view(side: Side): void
}

/** To the right, away, and upwards. */
const WAYS: Readonly<Record<string, readonly [number, number, number]>> = {
  ArrowLeft: [-1, 0, 0],
  ArrowRight: [1, 0, 0],
  ArrowUp: [0, 1, 0],
  ArrowDown: [0, -1, 0],
  PageUp: [0, 0, 1],
  PageDown: [0, 0, -1],
}
const VIEWS: Readonly<Record<string, Side>> = { '1': 'front', '2': 'side', '3': 'top', '4': 'corner' }
/** Degrees a key. */
const TURN = 6

/** What a key does on the stage in space; true if it did something. */
export function spaceKey(event: KeyboardEvent, acts: Acts): boolean {
  if (event.ctrlKey || event.metaKey || event.altKey) return false
  const way = WAYS[event.key]
  if (way) return move(way, event.shiftKey, acts)
  const view = VIEWS[event.key]
  if (view) {
    acts.view(view)
    return true
  }
  const { lab, pointer } = acts
  const far = event.shiftKey ? 10 : 1
  const keys: Readonly<Record<string, () => void>> = {
    ' ': () => (lab.followers.beside ? lab.followers.beside.clock.toggle() : lab.playback.toggle()),
    ',': () => step(lab, -far),
    ';': () => step(lab, -far),
    '<': () => step(lab, -far),
    '.': () => step(lab, far),
    ':': () => step(lab, far),
    '>': () => step(lab, far),
    Home: () => (lab.followers.beside ? lab.followers.beside.clock.seek(0) : lab.playback.seek(0)),
    End: () => (lab.followers.beside ? lab.followers.beside.clock.seek(lab.followers.beside.clock.end) : lab.playback.seek(Infinity)),
    '+': () => acts.zoom(1.25),
    '=': () => acts.zoom(1.25),
    '-': () => acts.zoom(0.8),
    '0': acts.fit,
    n: () => pointer.next(1),
    N: () => pointer.next(-1),
    a: () => pointer.add(acts.orbit),
    j: () => pointer.walk(-1),
    k: () => pointer.walk(1),
    Delete: () => pointer.remove(),
    Backspace: () => pointer.remove(),
    Escape: () => (lab.followers.beside && !lab.selection.object && !lab.selection.wanted ? lab.followers.beside.leave() : pointer.leave()),
  }
  const act = keys[event.key] ?? keys[event.key.toLowerCase()]
  act?.()
  return act !== undefined
}

/** Iterations of the run, or seconds of the time beside it. */
function step(lab: Lab, by: number): void {
  const { beside } = lab.followers
  if (!beside) lab.playback.stepBy(by)
  else beside.clock.seek(by < 0 ? Math.ceil(beside.clock.time) + by : Math.floor(beside.clock.time) + by)
}

function move(way: readonly [number, number, number], shift: boolean, { lab, pointer, orbit, turn }: Acts): boolean {
  if (lab.selection.object) {
    if (shift) pointer.stretch(orbit, way)
    else pointer.nudge(orbit, way)
    return true
  }
  if (way[2] !== 0) return false
  turn((shift ? 3 : 1) * TURN * way[0], (shift ? 3 : 1) * TURN * way[1])
  return true
}
