import { mount } from 'svelte'
import App from './App.svelte'
import Frame from './Frame.svelte'
import { useHost } from '../../engine/host'
import { Gone } from '../../engine/run-client'
import { pageHost } from './host'
import 'virtual:palette.css'
import '../../ui/theme/tokens.css'
import '../../ui/theme/base.css'

useHost(pageHost)

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

const target = document.getElementById('app')
if (target) mount(new URLSearchParams(location.search).has('embed') ? Frame : App, { target })
