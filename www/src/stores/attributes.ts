import type { Lab } from './lab.svelte'

/** How the run stands, as attributes of what shows it. */
export const attributesOf = ({ phase, playback, run }: Lab): Record<`data-${string}`, string> => ({
  'data-phase': phase,
  'data-iteration': String(playback.iteration),
  'data-limit': String(run.limit),
  'data-status': run.status,
  'data-playing': String(playback.playing),
  'data-hash': playback.hash,
  'data-stale': String(playback.stale),
})
