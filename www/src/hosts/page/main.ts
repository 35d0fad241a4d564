import { mount } from 'svelte'
import { useHost } from '../../engine/host'
import { common } from '../../locales/en/common'
import { prepare } from '../prepare'
import App from './App.svelte'
import { pageHost } from './host'
import 'virtual:palette.css'
import '../../ui/theme/tokens.css'
import '../../ui/theme/base.css'

useHost(pageHost)
const target = document.getElementById('app')
/** A frame in another page is a smaller thing, and the page is read by more. */
const isFrame = new URLSearchParams(location.search).has('embed')
const shown = isFrame ? import('./Frame.svelte').then((module) => module.default) : Promise.resolve(App)
shown.catch(() => undefined)
prepare()
  .then(async () => target && mount(await shown, { target }))
  .catch((error: unknown) => {
    if (target) target.textContent = common.notices.unloaded(error instanceof Error ? error.message : String(error))
  })
