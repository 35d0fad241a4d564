import { rise, type Size, type View } from '../view'

/** How a point hides what lies beneath adds up as a logarithm; so many units are a factor of e. */
const UNIT = 32
const FULL = 255
/** The opacity of so many units, as a byte. No more can be told apart. */
const OPACITY = Uint8Array.from({ length: FULL + 1 }, (_, units) => Math.round(FULL * (1 - Math.exp(-units / UNIT))))

const unitsOf = (opacity: number): number => Math.min(FULL, Math.round(-Math.log(1 - opacity) * UNIT))

/** Where the plane lies: pixels of x = 0 and y = 0, and of a unit to the right and upwards. */
export interface Place {
  left: number
  top: number
  right: number
  up: number
}

/** Pixels of a picture, and the side of its squares. */
export interface Grid {
  width: number
  height: number
  side: number
}

/** How many marks there are: where a square begins outside of the picture, part of it may be in it. */
export const marksOf = ({ width, height, side }: Grid): number => (width + side) * (height + side)

/** Rows and columns of marks that are in use: from the first to before the last. */
export interface Used {
  left: number
  right: number
  top: number
  low: number
}

/**
 * Marks where the square about each vertex (x, y, z, weight) begins, by the opacity of its step of weights. `marks` are to be zeros.
 * Squares lie on whole pixels.
 */
export function mark(
  { width, height, side }: Grid,
  marks: Uint32Array,
  place: Place,
  steps: readonly number[],
  vertices: Float32Array,
): Used {
  const units = Uint32Array.from(steps, unitsOf)
  const last = units.length - 1
  const [wide, high] = [width + side, height + side]
  // Of a square's corner, rounded, from the corner of the marks.
  const { right, up } = place
  const x0 = place.left + side / 2 + 0.5
  const y0 = place.top + side / 2 + 0.5
  let [least, most, first, end] = [wide, 0, high, 0]
  for (let at = 0; at < vertices.length; at += 4) {
    const x = x0 + (vertices[at] as number) * right
    const y = y0 - (vertices[at + 1] as number) * up
    // What is not a number is nowhere.
    if (!(x >= 1 && y >= 1 && x < wide && y < high)) continue
    const [column, row] = [x | 0, y | 0]
    if (column < least) least = column
    if (column > most) most = column
    if (row < first) first = row
    if (row > end) end = row
    const step = Math.min(last, Math.max(0, ((vertices[at + 3] as number) * units.length) | 0))
    const pixel = row * wide + column
    marks[pixel] = (marks[pixel] as number) + (units[step] as number)
  }
  return { left: least, right: most + 1, top: first, low: end + 1 }
}

/** Makes squares of the marks, in a colour: running sums along rows and down columns, so that their size costs nothing. */
export function spread({ width, height, side }: Grid, marks: Uint32Array, used: Used, colour: number, words: Uint32Array): void {
  words.fill(0)
  const wide = width + side
  // A mark is seen in so many rows and columns from its own on; the first of a picture are those of mark `side`.
  const [from, to] = [Math.max(used.left, side), Math.min(used.right + side - 1, wide)]
  const columns = new Uint32Array(wide)
  /** The sums along the last rows. */
  const rows = Array.from({ length: side }, () => new Uint32Array(wide))
  for (let row = used.top; row < Math.min(used.low + side - 1, height + side); row += 1) {
    const sums = rows[row % side] as Uint32Array
    const line = row * wide
    const shown = (row - side) * width - side
    let sum = 0
    for (let at = from - side + 1; at < from; at += 1) sum += marks[line + at] as number
    for (let column = from; column < to; column += 1) {
      sum += marks[line + column] as number
      const all = (columns[column] as number) + sum - (sums[column] as number)
      columns[column] = all
      sums[column] = sum
      sum -= marks[line + column - side + 1] as number
      if (row >= side && all > 0) words[shown + column] = ((OPACITY[all < FULL ? all : FULL] as number) << 24) | colour
    }
  }
}

/** The bytes of a colour as a canvas writes it, `#rrggbb`; little-endian, as all machines are that have a browser. */
function packed(colour: string): number {
  const [red = 0, green = 0, blue = 0] = [1, 3, 5].map((at) => Number.parseInt(colour.slice(at, at + 2), 16))
  return red | (green << 8) | (blue << 16)
}

let sheet: { grid: Grid; canvas: OffscreenCanvas; image: ImageData; marks: Uint32Array } | null = null

function sheetOf(grid: Grid): NonNullable<typeof sheet> {
  const { width, height, side } = grid
  if (sheet?.grid.width === width && sheet.grid.height === height && sheet.grid.side === side) {
    sheet.marks.fill(0)
    return sheet
  }
  sheet = { grid, canvas: new OffscreenCanvas(width, height), image: new ImageData(width, height), marks: new Uint32Array(marksOf(grid)) }
  return sheet
}

interface Target {
  context: Pick<OffscreenCanvasRenderingContext2D, 'drawImage' | 'fillStyle'>
  view: View
  size: Size
  density: number
}

/** Draws squares in the context's colour, `steps` being the opacity of each step of weights. */
export function squares({ context, view, size, density }: Target, side: number, steps: readonly number[], vertices: Float32Array): void {
  const [width, height] = [Math.round(size.width * density), Math.round(size.height * density)]
  if (width < 1 || height < 1) return
  const { grid, canvas, image, marks } = sheetOf({ width, height, side: Math.max(1, Math.round(side * density)) })
  const right = view.scale * density
  const up = rise(view) * right
  const used = mark(grid, marks, { left: width / 2 - view.x * right, top: height / 2 + view.y * up, right, up }, steps, vertices)
  spread(grid, marks, used, packed(String(context.fillStyle)), new Uint32Array(image.data.buffer))
  canvas.getContext('2d')?.putImageData(image, 0, 0)
  context.drawImage(canvas, 0, 0, size.width, size.height)
}
