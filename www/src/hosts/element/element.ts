import { useHost } from '../../engine/host'
import { inlinedHost } from '../inlined/host'
import { ForageRun } from './forage-run.svelte'
import 'virtual:palette.css'
import '../../ui/theme/tokens.css'
import '../../ui/theme/base.css'

// A page may have the script twice: the first one serves all.
if (!customElements.get('forage-run')) {
  useHost(inlinedHost)
  customElements.define('forage-run', ForageRun)
}
