import type { Path } from '../canvas/pen'

/** To a thousandth: nobody sees what is finer. */
const exact = (value: number): string => String(Math.round(value * 1000) / 1000)

/** A path as SVG writes it. */
export class VectorPath implements Path {
  constructor(public d = '') {}

  moveTo(x: number, y: number): void {
    this.put('M', x, y)
  }

  lineTo(x: number, y: number): void {
    this.put('L', x, y)
  }

  closePath(): void {
    this.d += 'Z'
  }

  rect(x: number, y: number, width: number, height: number): void {
    this.put('M', x, y)
    this.d += `h${exact(width)}v${exact(height)}h${exact(-width)}Z`
  }

  roundRect(x: number, y: number, width: number, height: number, radius: number): void {
    const r = Math.min(radius, width / 2, height / 2)
    const [wide, high, round] = [width - 2 * r, height - 2 * r, exact(r)]
    const corner = (dx: number, dy: number): string => `a${round} ${round} 0 0 1 ${exact(dx)} ${exact(dy)}`
    this.put('M', x + r, y)
    this.d += `h${exact(wide)}${corner(r, r)}v${exact(high)}${corner(-r, r)}h${exact(-wide)}${corner(-r, -r)}v${exact(-high)}${corner(r, -r)}Z`
  }

  /** Clockwise, as all arcs of the stage are. */
  arc(x: number, y: number, radius: number, from: number, to: number): void {
    const at = (angle: number): [number, number] => [x + radius * Math.cos(angle), y + radius * Math.sin(angle)]
    this.put(this.d === '' ? 'M' : 'L', ...at(from))
    // A whole turn ends where it begins: its halves tell which way it goes.
    const parts = Math.max(1, Math.ceil((to - from) / Math.PI))
    for (let part = 1; part <= parts; part += 1) {
      this.d += `A${exact(radius)} ${exact(radius)} 0 0 1 ${at(from + ((to - from) * part) / parts)
        .map(exact)
        .join(' ')}`
    }
  }

  private put(command: string, x: number, y: number): void {
    this.d += `${command}${exact(x)} ${exact(y)}`
  }
}
