import { CONTROLS, type Controls } from '../../catalogue/embedding'
import { type Choice, isChoice } from '../../stores/theme.svelte'

/** How an embedded run is shown. */
export interface EmbedOptions {
  controls: Controls
  theme: Choice
  autoplay: boolean
}

const isControls = (value: string | null): value is Controls => CONTROLS.some((control) => control === value)

/** What is not there, or not to be understood, is as usual. */
export const optionsOf = (read: (name: string) => string | null): EmbedOptions => {
  const [controls, theme] = [read('controls'), read('theme')]
  return {
    controls: isControls(controls) ? controls : 'play',
    theme: isChoice(theme) ? theme : 'system',
    autoplay: read('autoplay') !== null,
  }
}
