import { tick } from 'svelte'
import { canvasesOf } from '../stage/canvases'
import type { Clock } from '../../stores/clock.svelte'
import type { Lab } from '../../stores/lab.svelte'

/** While a bar with a time of its own is there, the stage's keys are for it. */
export function takeKeys({ followers }: Lab, clock: Clock, leave: () => void): () => void {
  const own = { clock, leave }
  followers.beside = own
  return () => {
    if (followers.beside === own) followers.beside = null
  }
}

/** Leaves what has a bar of its own: the bar goes, and with it what was focused. */
export async function backTo(lab: Lab, leave: () => void): Promise<void> {
  leave()
  await tick()
  if (document.activeElement === document.body) canvasesOf(lab).canvas?.focus({ preventScroll: true })
}
