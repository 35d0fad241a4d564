import type { Theme } from '../../render/palette'

/** How figures are saved: kept from one to the next. */
class FigureChoices {
  /** Pixels of a picture for each pixel of the page. */
  density = $state<'1' | '2' | '4'>('1')
  look = $state<'shown' | 'print'>('shown')
  /** Below a figure: what it shows, what its lines are, and where the run is. */
  captioned = $state(true)

  theme(dark: boolean): Theme {
    return this.look === 'print' ? { dark: false, print: true } : { dark }
  }
}

export const choices = new FigureChoices()
