/** The tokens' values as the canvas needs them; read anew when the theme changes. */
export class Palette {
  private known = new Map<string, string>()
  private style: CSSStyleDeclaration

  constructor(element: Element) {
    this.style = getComputedStyle(element)
  }

  refresh(): void {
    this.known.clear()
  }

  get(token: string): string {
    let colour = this.known.get(token)
    if (colour === undefined) {
      colour = this.style.getPropertyValue(token).trim()
      this.known.set(token, colour)
    }
    return colour
  }
}
