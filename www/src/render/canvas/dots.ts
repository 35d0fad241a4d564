import { rise, type Size, type View } from '../view'

/** Opacities are told apart as bytes. */
const FULL = 255

/** Pixels that are more or less opaque, row by row. */
export interface Opacities {
  width: number
  height: number
  pixels: Uint8Array
}

/** Where the plane lies: pixels of x = 0 and y = 0, and of a unit to the right and upwards. */
export interface Place {
  left: number
  top: number
  right: number
  up: number
}

/** How opaque a pixel is that something of this opacity is drawn over, by how opaque it was. */
const over = (opacity: number): Uint8Array =>
  Uint8Array.from({ length: FULL + 1 }, (_, before) => Math.round(before + (FULL - before) * opacity))

/**
 * Covers squares of so many pixels a side about vertices (x, y, z, weight). `steps`: the opacity of each step of weights. Squares lie
 * on whole pixels.
 */
export function cover(
  { width, height, pixels }: Opacities,
  place: Place,
  side: number,
  steps: readonly number[],
  vertices: Float32Array,
): void {
  const tables = steps.map(over)
  const [left, top] = [place.left - side / 2, place.top - side / 2]
  for (let at = 0; at < vertices.length; at += 4) {
    const x = Math.round(left + (vertices[at] as number) * place.right)
    const y = Math.round(top - (vertices[at + 1] as number) * place.up)
    // What is not a number is nowhere.
    if (!(x > -side && y > -side && x < width && y < height)) continue
    const step = Math.floor((vertices[at + 3] as number) * tables.length)
    const table = tables[Math.min(tables.length - 1, Math.max(0, step))] as Uint8Array
    const [from, to, low] = [Math.max(0, x), Math.min(x + side, width), Math.min(y + side, height)]
    for (let row = Math.max(0, y); row < low; row += 1)
      for (let pixel = row * width + from; pixel < row * width + to; pixel += 1) pixels[pixel] = table[pixels[pixel] as number] as number
  }
}

/** The bytes of a colour as a canvas writes it, `#rrggbb`; little-endian, as all machines are that have a browser. */
function packed(colour: string): number {
  const [red = 0, green = 0, blue = 0] = [1, 3, 5].map((at) => Number.parseInt(colour.slice(at, at + 2), 16))
  return red | (green << 8) | (blue << 16)
}

let sheet: { canvas: OffscreenCanvas; image: ImageData; opacities: Opacities } | null = null

function sheetOf(width: number, height: number): NonNullable<typeof sheet> {
  if (sheet?.canvas.width === width && sheet.canvas.height === height) {
    sheet.opacities.pixels.fill(0)
    return sheet
  }
  const opacities = { width, height, pixels: new Uint8Array(width * height) }
  sheet = { canvas: new OffscreenCanvas(width, height), image: new ImageData(width, height), opacities }
  return sheet
}

interface Target {
  context: Pick<OffscreenCanvasRenderingContext2D, 'drawImage' | 'fillStyle'>
  view: View
  size: Size
  density: number
}

/** Draws squares in the context's colour: written into pixels they cost a tenth of what the browser needs to fill each. */
export function squares({ context, view, size, density }: Target, side: number, steps: readonly number[], vertices: Float32Array): void {
  const [width, height] = [Math.round(size.width * density), Math.round(size.height * density)]
  if (width < 1 || height < 1) return
  const { canvas, image, opacities } = sheetOf(width, height)
  const right = view.scale * density
  const up = rise(view) * right
  const place: Place = { left: width / 2 - view.x * right, top: height / 2 + view.y * up, right, up }
  cover(opacities, place, Math.max(1, Math.round(side * density)), steps, vertices)
  const colour = packed(String(context.fillStyle))
  const words = new Uint32Array(image.data.buffer)
  const { pixels } = opacities
  for (let at = 0; at < words.length; at += 1) words[at] = ((pixels[at] as number) << 24) | colour
  canvas.getContext('2d')?.putImageData(image, 0, 0)
  context.drawImage(canvas, 0, 0, size.width, size.height)
}
