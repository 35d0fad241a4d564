/* What modules ask a browser for when they are loaded: no motion, no link, an address that can be written. */
import { vi } from 'vitest'

vi.stubGlobal('matchMedia', (query: string) =>
  Object.assign(new EventTarget(), { matches: query.includes('reduced-motion'), media: query }),
)
vi.stubGlobal('location', { hash: '', href: 'http://127.0.0.1/' })
vi.stubGlobal('requestAnimationFrame', () => 0)
vi.stubGlobal('cancelAnimationFrame', () => undefined)
vi.stubGlobal('history', { state: null, replaceState: () => undefined })
