import { mount } from 'svelte'
import { useHost } from '../../engine/host'
import { prepare } from '../prepare'
import App from './App.svelte'
import Frame from './Frame.svelte'
import { pageHost } from './host'
import 'virtual:palette.css'
import '../../ui/theme/tokens.css'
import '../../ui/theme/base.css'

useHost(pageHost)
const target = document.getElementById('app')
void prepare().then(() => target && mount(new URLSearchParams(location.search).has('embed') ? Frame : App, { target }))
