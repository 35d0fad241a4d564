import type { Color } from 'forage-lab'
import tokens from '../../../src/describe/palette.json'

const PALETTE: Readonly<Record<string, readonly string[] | undefined>> = tokens

/** Which of the palette's colours a canvas has. */
export interface Theme {
  dark: boolean
  /** On paper: a white ground, black text. */
  print?: boolean
  /** The best result has this colour where it is one of several. */
  best?: string
}

/** A theme's colours: of a token, as style sheets have it, or of a look. */
export class Palette {
  constructor(private readonly theme: Theme) {}

  get(token: string | Color): string {
    const { dark, print = false, best } = this.theme
    if (typeof token !== 'string') return dark ? token.dark : token.light
    const own = best !== undefined && token === '--best' ? best : token
    const [light = '', night = '', paper = light] = PALETTE[own.slice(2)] ?? []
    return print ? paper : dark ? night : light
  }
}

/** A token's colours, by day and by night. */
export function colorOf(token: string): Color {
  const [light = '', dark = ''] = PALETTE[token.slice(2)] ?? []
  return { light, dark }
}
