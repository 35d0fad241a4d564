import { forget, recall, remember } from './storage'

/* The Workshop's address is not that of a run: the browser keeps the last one that was seen there. */

const RUN = 'workshop.run'

/** Keeps the link of the run; of one with somebody else's code, or without a link, nothing: that is to be seen before it runs. */
export function keepRun(link: string | null): void {
  if (link === null) forget(RUN)
  else remember(RUN, link)
}

export const recallRun = (): string | null => recall(RUN)
