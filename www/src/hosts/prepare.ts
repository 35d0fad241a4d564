import { Gone } from '../engine/run-client'

/** What a page of ours does before anything else. */
export function prepare(): void {
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
}
