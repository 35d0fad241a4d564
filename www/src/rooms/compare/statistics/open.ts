import { lab } from '../../../stores/lab.svelte'
import { views } from '../../../stores/views.svelte'
import type { Run } from './shown'
import { looks } from './looks.svelte'

/** Exactly this run, where it ended, on the stage. */
export function openRun(run: Run, returns = false): Promise<boolean> {
  if (returns) looks.opened = run.row.link
  views.current = 'stage'
  return lab.openLink(run.row.link)
}
