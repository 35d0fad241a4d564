/* Keeps what the page is made of, so that it opens without a network. */
import { addRoute, cleanupOutdatedCaches, precache } from 'workbox-precaching'

/** Files of the build and their versions: put there while building. */
declare const PRECACHED: { url: string; revision: string | null }[]

precache(PRECACHED)
cleanupOutdatedCaches()
// What comes after the question mark says how the page shows a run, not which page it is.
addRoute({ ignoreURLParametersMatching: [/./] })

// A new version waits until somebody asks for it: a lecture goes on with the one that it began with.
addEventListener('message', ({ data }: MessageEvent<{ type?: string } | null>) => {
  if (data?.type === 'SKIP_WAITING') void (globalThis as unknown as { skipWaiting(): Promise<void> }).skipWaiting()
})
