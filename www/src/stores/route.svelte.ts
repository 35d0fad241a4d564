import { language } from '../locales/language.svelte'
import { shortened } from './large-links'
import { followLanguage, languageKey, withoutLanguage } from './language'

/** The rooms: where a newcomer begins, one run, several compared, what was published, where planners are written. */
export const VIEWS = ['learn', 'lab', 'compare', 'workshop', 'papers'] as const
export type View = (typeof VIEWS)[number]

/** Older addresses, and what they were of in today's words. */
const HEIRS = new Map<string, readonly [View, string]>([
  ['stage', ['lab', '']],
  ['race', ['compare', '&as=watch&budget=own']],
  ['batch', ['compare', '&as=statistics&budget=own']],
])

const PREFIX = '#view='
/** Of a lesson, as embeds have it. */
const LESSON = '#lesson='
/** While a run plays, its link is written seldom, in milliseconds. Browsers count how often an address changes: a burst of edits is written once. */
const INTERVAL = 3000
const LEAST = 300

/** The view that an address is of, and what it says of it: `#view=compare&seeds=3-9`. Others are links of runs. */
function placeOf(address: string): { view: View; keys: string } | undefined {
  const hash = withoutLanguage(address)
  if (hash.startsWith(LESSON)) return { view: 'learn', keys: `&${hash.slice(1)}` }
  const [name = '', ...rest] = hash.startsWith(PREFIX) ? hash.slice(PREFIX.length).split('&') : []
  const keys = rest.map((pair) => `&${pair}`).join('')
  const [heir, meant] = HEIRS.get(name) ?? []
  if (heir) return { view: heir, keys: meant + keys }
  const view = VIEWS.find((known) => known === name)
  return view && { view, keys }
}

/** Without an address the page is for those who do not know it yet; a run's link is the lab's. */
const viewOf = (hash: string): View => placeOf(hash)?.view ?? (withoutLanguage(hash).length > 1 ? 'lab' : 'learn')

const wishOf = (keys: string): { readonly keys: string; taken: boolean } => ({ keys, taken: keys === '' })

/** What is shown, and its address. Nothing else writes the address. */
class Route {
  view = $state<View>(viewOf(location.hash))
  /** What the address wants of the view that it is of: taken by the view. */
  private wanted = $state.raw(wishOf(placeOf(location.hash)?.keys ?? ''))
  /** How each view stands, as keys. */
  private readonly standing = new Map<View, string>()
  /** The newest link of the run, and what is added to it: how the page shows the run. */
  private link = ''
  added = ''
  private last = 0
  private timer: ReturnType<typeof setTimeout> | undefined
  /** A link of the address is being opened: until its run writes its own, the address stays. */
  private opening = false
  /** Grows with each link that is opened from the address: entries of the history with this number are of the run that is here. */
  private opened = Date.now()

  constructor() {
    language.listeners.add(() => this.replaceSoon(0))
  }

  /** The link that the page was opened on, if it was one. */
  get first(): string | null {
    const hash = withoutLanguage(location.hash)
    return hash.length > 1 && !placeOf(hash) ? hash : null
  }

  /** The run is what is looked at. */
  get watched(): boolean {
    return this.view === 'lab' || this.view === 'learn' || this.view === 'workshop'
  }

  /** The address of what is shown, as it is now. */
  get href(): string {
    return new URL(this.address || '#', location.href).href
  }

  /** Shows another view. The one of before is a step back. */
  go = (view: View): void => {
    if (view === this.view) return
    this.view = view
    this.wanted = wishOf('')
    clearTimeout(this.timer)
    history.pushState(this.mark, '', this.address || '#')
  }

  /** Shows a view as its keys say. What was shown before is a step back. */
  open = (view: View, keys: string): void => {
    this.view = view
    this.wanted = { keys, taken: false }
    this.standing.set(view, keys)
    clearTimeout(this.timer)
    history.pushState(this.mark, '', this.address)
  }

  /** The run's link: at once where it stays, seldom while it plays. */
  write(link: string, when: 'now' | 'soon'): void {
    this.opening = false
    this.link = shortened(link)
    if (this.view === 'lab') this.replaceWhen(when)
  }

  /** How a view stands, as keys of its address. */
  stand(view: View, keys: string, when: 'now' | 'soon'): void {
    this.standing.set(view, shortened(keys))
    // What the address wants of it is not done yet.
    if (view === this.view && this.wanted.taken) this.replaceWhen(when)
  }

  keysOf = (view: View): string => this.standing.get(view) ?? ''

  /** What the address wants of a view, once: its keys with their values as they are written. */
  take(view: View): ReadonlyMap<string, string> | null {
    const { wanted } = this
    if (view !== this.view || wanted.taken) return null
    wanted.taken = true
    const pairs = wanted.keys.slice(1).split('&')
    return new Map(pairs.map((pair) => [pair.split('=')[0] ?? '', pair.slice(pair.indexOf('=') + 1)]))
  }

  /** Keys of the page that are added to the run's link. */
  add(keys: string): void {
    if (keys === this.added) return
    this.added = keys
    if (this.link !== '') this.replaceSoon(LEAST)
  }

  /** The address becomes that of what is shown, if it waits for that. */
  flush(): void {
    this.replace()
  }

  private get address(): string {
    if (this.view !== 'lab') return PREFIX + this.view + (this.standing.get(this.view) ?? '') + languageKey()
    return this.link === '' ? '' : this.link + this.added + languageKey()
  }

  private replaceWhen(when: 'now' | 'soon'): void {
    const since = performance.now() - this.last
    if (when === 'now') this.replaceSoon(LEAST - since)
    else if (since >= INTERVAL) this.replace()
  }

  private replaceSoon(wait: number): void {
    clearTimeout(this.timer)
    if (wait <= 0) this.replace()
    else this.timer = setTimeout(() => this.replace(), wait)
  }

  private replace(): void {
    clearTimeout(this.timer)
    this.last = performance.now()
    const { address } = this
    if (!this.opening && address !== '' && location.hash !== address) history.replaceState(this.mark, '', address)
  }

  /** The address is another one: by the browser's buttons, or because somebody wrote it. Returns the link that is to be opened. */
  follow(hash: string): string | null {
    followLanguage(hash)
    const place = placeOf(hash)
    this.view = viewOf(hash)
    this.opening = false
    if (place) {
      // Without keys it is as it stands; only Learn has a list to come back to.
      const known = (place.keys === '' && place.view !== 'learn') || place.keys === (this.standing.get(place.view) ?? '')
      this.wanted = known ? wishOf('') : { keys: place.keys, taken: false }
      if (known) this.replace()
      return null
    }
    // What somebody wrote may have been overwritten by the run's link before anybody was told of it: the entry is marked as ours then.
    const overwritten = location.hash !== hash
    if (!overwritten && this.link !== '' && (history.state as typeof this.mark | null)?.opened === this.opened) {
      this.replace()
      return null
    }
    this.opened += 1
    this.opening = hash.length > 1
    return this.opening ? withoutLanguage(hash) : null
  }

  private get mark(): { opened: number } {
    return { opened: this.opened }
  }
}

export const route = new Route()
