import type { Lab } from '../../../stores/lab.svelte'
import { route } from '../../../stores/route.svelte'
import type { Run } from './shown'
import { looks } from './looks.svelte'

/** Exactly this run, where it ended, in the lab. */
export function openRun(lab: Lab, run: Run, returns = false): Promise<boolean> {
  if (returns) looks.opened = run.row.link
  route.go('lab')
  return lab.openLink(run.row.link)
}
