import { mount } from 'svelte'
import App from './App.svelte'
import 'virtual:palette.css'
import './theme/tokens.css'
import './theme/base.css'

const target = document.getElementById('app')
if (target) mount(App, { target })
