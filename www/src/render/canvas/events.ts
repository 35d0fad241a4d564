import type { Point } from 'forage-lab'
import { type Pen, pathOf } from './pen'
import { type Tone, TONES } from './tones'
import { toScreen } from '../view'

/** A mark's square is so many pixels wide, of 16 that it is drawn on. */
const SIDE = 14

/** Where something happened or was decided: what calls for attention lies on top, and what is not known yet is plain. */
export function drawEvents(pen: Pen, places: readonly Point[], known: readonly Tone[]): void {
  const { context, view, size, palette } = pen
  const tones = places.map((_, index) => known[index] ?? 'plain')
  context.setLineDash([])
  context.lineJoin = context.lineCap = 'round'
  for (const [tone, { colour, outline: around, sign: within }] of Object.entries(TONES)) {
    const [outline, sign] = [pathOf(pen, around), pathOf(pen, within)]
    places.forEach((place, index) => {
      if (tones[index] !== tone) return
      const [x, y] = toScreen(view, size, place)
      context.save()
      context.translate(x - SIDE / 2, y - SIDE / 2)
      context.scale(SIDE / 16, SIDE / 16)
      context.strokeStyle = palette.get('--stage')
      context.lineWidth = 5
      context.stroke(outline)
      context.fillStyle = context.strokeStyle = palette.get(colour)
      context.lineWidth = 1.2
      context.fill(outline)
      context.stroke(outline)
      context.strokeStyle = palette.get('--stage')
      context.lineWidth = 1.7
      context.stroke(sign)
      context.restore()
    })
  }
}
