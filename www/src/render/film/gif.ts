import { applyPalette, GIFEncoder, quantize } from 'gifenc'
import type { Encoder, FilmContext } from './encoder'

/** Colours a picture has at most: one of 256 stands for what has not changed. */
const COLOURS = 255
/** So many of them are those of most pixels. */
const EXACT = 128

/** A GIF: after the first picture only what has changed is written. The same pictures give the same bytes. */
export class Gif implements Encoder {
  private readonly gif = GIFEncoder()
  private before: Uint32Array | null = null
  private readonly delay: number

  /** GIFs count hundredths of a second. */
  constructor(
    private readonly context: FilmContext,
    rate: number,
  ) {
    this.delay = 10 * Math.max(2, Math.round(100 / rate))
  }

  add(): Promise<void> {
    const { width, height } = this.context.canvas
    const { data } = this.context.getImageData(0, 0, width, height)
    const now = new Uint32Array(data.buffer)
    const { before } = this
    const changed = before ? now.filter((pixel, at) => pixel !== before[at]) : now
    const { palette, index } = coloured(changed)
    const all = before ? new Uint8Array(now.length).fill(palette.length) : index
    if (before) {
      let next = 0
      now.forEach((pixel, at) => {
        if (pixel !== before[at]) all[at] = index[next++] ?? 0
      })
      palette.push([0, 0, 0])
    }
    // What lies beneath stays.
    const kept = before && { transparent: true, transparentIndex: palette.length - 1, dispose: 1 }
    this.gif.writeFrame(all, width, height, { palette, delay: this.delay, ...kept })
    this.before = now
    return Promise.resolve()
  }

  end(): Promise<Blob> {
    this.gif.finish()
    return Promise.resolve(new Blob([this.gif.bytes()], { type: 'image/gif' }))
  }

  cancel(): Promise<void> {
    return Promise.resolve()
  }
}

/** Colours for these pixels, and which of them each has: those of grounds and areas are exact, those of rims and blends near. */
function coloured(pixels: Uint32Array): { palette: [number, number, number][]; index: Uint8Array } {
  const counts = new Map<number, number>()
  for (const pixel of pixels) counts.set(pixel, (counts.get(pixel) ?? 0) + 1)
  const frequent = [...counts].sort(([a, m], [b, n]) => n - m || a - b).slice(0, EXACT)
  const exact = new Map(frequent.map(([pixel], at) => [pixel, at]))
  const palette = frequent.map(([pixel]): [number, number, number] => [pixel & 0xff, (pixel >> 8) & 0xff, (pixel >> 16) & 0xff])
  const others = Uint32Array.from([...counts.keys()].filter((pixel) => !exact.has(pixel)))
  if (others.length > 0) {
    const rest = pixels.filter((pixel) => !exact.has(pixel))
    const near = quantize(new Uint8Array(rest.buffer), COLOURS - palette.length)
    applyPalette(new Uint8Array(others.buffer), near).forEach((colour, at) => {
      exact.set(others[at] ?? 0, palette.length + colour)
    })
    palette.push(...near)
  }
  if (palette.length === 0) palette.push([0, 0, 0])
  return { palette, index: Uint8Array.from(pixels, (pixel) => exact.get(pixel) ?? 0) }
}
