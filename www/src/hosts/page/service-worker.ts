/* Keeps what the page is made of, so that it opens without a network. */
import { addRoute, cleanupOutdatedCaches, precache } from 'workbox-precaching'

/** Files of the build and their versions: put there while building. */
declare const PRECACHED: { url: string; revision: string | null }[]
/** Changes with any of them. */
declare const VERSION: string

precache(PRECACHED)
cleanupOutdatedCaches()
// What comes after the question mark says how the page shows a run, not which page it is.
addRoute({ ignoreURLParametersMatching: [/./] })

/** The page in one file is large, and asked for seldom: it is kept where the page was installed. */
const FILE = 'single-file.html'
const KEPT = 'forage-file-'
const cacheName = `${KEPT}${VERSION}`

async function keepFile(): Promise<void> {
  const cache = await caches.open(cacheName)
  if (!(await cache.match(FILE))) await cache.add(FILE)
}

async function dropOlder(): Promise<void> {
  const names = (await caches.keys()).filter((name) => name.startsWith(KEPT) && name !== cacheName)
  await Promise.all(names.map((name) => caches.delete(name)))
}

interface Extended extends Event {
  waitUntil(done: Promise<unknown>): void
}

interface Fetched extends Extended {
  readonly request: Request
  respondWith(response: Promise<Response>): void
}

addEventListener('activate', (event) => (event as Extended).waitUntil(dropOlder()))
addEventListener('fetch', (event) => {
  const { request, respondWith } = event as Fetched
  if (new URL(request.url).pathname.endsWith(`/${FILE}`))
    respondWith.call(
      event,
      caches.match(request).then((kept) => kept ?? fetch(request)),
    )
})

// A new version waits until somebody asks for it: a lecture goes on with the one that it began with.
addEventListener('message', (event: MessageEvent<{ type?: string } | null>) => {
  const { data } = event
  // Where there is no room the file comes over the network.
  if (data?.type === 'KEEP_FILE') (event as unknown as Extended).waitUntil(keepFile().catch(() => undefined))
  if (data?.type === 'SKIP_WAITING') void (globalThis as unknown as { skipWaiting(): Promise<void> }).skipWaiting()
})
