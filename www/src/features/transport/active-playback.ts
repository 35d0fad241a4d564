import { tick } from 'svelte'
import { picture } from '../stage/picture'
import type { Clock } from '../../stores/clock.svelte'
import { lab } from '../../stores/lab.svelte'

/** While a bar with a time of its own is there, the stage's keys are for it. */
export function takeKeys(clock: Clock, leave: () => void): () => void {
  const own = { clock, leave }
  lab.beside = own
  return () => {
    if (lab.beside === own) lab.beside = null
  }
}

/** Leaves what has a bar of its own: the bar goes, and with it what was focused. */
export async function backTo(leave: () => void): Promise<void> {
  leave()
  await tick()
  if (document.activeElement === document.body) picture.canvas?.focus({ preventScroll: true })
}
