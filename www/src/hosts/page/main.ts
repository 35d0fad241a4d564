import { mount } from 'svelte'
import App from './App.svelte'
import { gone } from '../../stores/transport.svelte'
import 'virtual:palette.css'
import '../../ui/theme/tokens.css'
import '../../ui/theme/base.css'

// The page says that the thread broke down: what waited for an answer of it has nothing to add.
addEventListener('unhandledrejection', (event) => {
  if (event.reason === gone) event.preventDefault()
})

const target = document.getElementById('app')
if (target) mount(App, { target })
