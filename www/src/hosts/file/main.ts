import { mount } from 'svelte'
import { useHost } from '../../engine/host'
import { inlinedHost } from '../inlined/host'
import { prepare } from '../prepare'
import File from './File.svelte'
import 'virtual:palette.css'
import '../../ui/theme/tokens.css'
import '../../ui/theme/literata.css'
import '../../ui/theme/base.css'

document.currentScript?.remove()

// As it was opened, before the page is put into it.
const source = `<!doctype html>\n${document.documentElement.outerHTML}\n`.replace(/ data-link="[^"]*"/, ' data-link=""')
useHost({ ...inlinedHost, singleFile: () => Promise.resolve(source) })
const target = document.getElementById('app')
void prepare().then(() => target && mount(File, { target }))
