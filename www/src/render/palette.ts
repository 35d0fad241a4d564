import type { Color } from 'forage-lab'

/** The tokens' values as the canvas needs them; read anew when the theme changes. */
export class Palette {
  private known = new Map<string, string>()
  private style: CSSStyleDeclaration
  private dark: boolean | undefined

  constructor(element: Element) {
    this.style = getComputedStyle(element)
  }

  refresh(): void {
    this.known.clear()
    this.dark = undefined
  }

  /** A token's value, or a colour by the theme. */
  get(token: string | Color): string {
    if (typeof token !== 'string') {
      this.dark ??= this.style.colorScheme === 'dark'
      return this.dark ? token.dark : token.light
    }
    let colour = this.known.get(token)
    if (colour === undefined) {
      colour = this.style.getPropertyValue(token).trim()
      this.known.set(token, colour)
    }
    return colour
  }
}
