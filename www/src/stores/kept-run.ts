import { shortened } from './large-links'
import { forget, recall, remember } from './storage'

/* The Workshop's address is not that of a run: the browser keeps the last run of a planner that the user wrote. */

const RUN = 'workshop.run'
/** The link that was kept here, or taken. */
let known: string | null = null

/** Keeps the link of a run. */
export function rememberRun(link: string): void {
  known = shortened(link)
  forget(RUN)
  remember(RUN, known)
}

/** Forgets the run that was kept here; another tab's stays. */
export function forgetRun(): void {
  if (recall(RUN) === known) forget(RUN)
}

/** The run that is kept. It is kept no longer, until it has been seen: it may be why the page did not come so far. */
export function takeRun(): string | null {
  const link = recall(RUN)
  known = link
  forget(RUN)
  return link
}

/** A link is that of the user's own run. */
export const isKept = (link: string): boolean => link === known
