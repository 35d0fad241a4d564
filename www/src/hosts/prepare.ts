import { Gone } from '../engine/run-client'
import { language } from '../locales/language.svelte'
import { common } from '../locales/en/common'
import { firstLanguage } from '../stores/language'

/** The document is in the language of the page. */
function name(): void {
  document.documentElement.lang = language.tag
  document.title = common.title
  document.querySelector('meta[name=description]')?.setAttribute('content', common.description)
  const manifest = document.querySelector<HTMLLinkElement>('link[rel=manifest]')
  if (manifest) manifest.href = language.tag === 'en' ? './manifest.webmanifest' : `./manifest.${language.tag}.webmanifest`
}

/** What a page of ours does before anything else; it speaks its language then. */
export async function prepare(): Promise<void> {
  // The language of a plain kiosk is `C`, which is none: a library that formats numbers by it would throw.
  try {
    new Intl.NumberFormat(navigator.language)
  } catch {
    Object.defineProperty(navigator, 'language', { value: document.documentElement.lang })
  }

  // The page says that the thread broke down: what waited for an answer of it has nothing to add.
  addEventListener('unhandledrejection', (event) => {
    if (event.reason instanceof Gone) event.preventDefault()
  })

  language.listeners.add(name)
  // A file may have been saved with a run.
  const first = firstLanguage(location.hash || (document.documentElement.dataset.link ?? ''), location.search)
  if (first !== 'en') await language.speak(first, true).catch((error: unknown) => console.warn(error))
}
