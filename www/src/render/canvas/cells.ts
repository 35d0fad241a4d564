import type { GridScene } from 'forage-lab'
import { type Cell, columnsOf, middleOf, radiusOf } from '../../scene/cells'
import { outlineOf } from './outline'
import type { Palette } from '../palette'
import type { Context, Pen } from './pen'
import { type Size, toScreen, type View } from '../view'

/** Cells of fewer pixels have no lines between them. */
const LINES_FROM = 7
/** Grids of more pieces are drawn anew only when the view has come to rest. */
const HEAVY = 3000
/** In larger ones even finding the pieces of what is being painted takes too long. */
const LARGE = 10_000
const REST = 220

interface Place {
  left: number
  top: number
  /** Pixels a cell. */
  side: number
}

/** A grid's cells with the margin around them, kept as a picture: a run draws it sixty times a second. */
export class Cells {
  private canvas: OffscreenCanvas | null = null
  private what = ''
  private where = ''
  private place: Place | null = null
  private size: Size | null = null
  private rest: ReturnType<typeof setTimeout> | undefined
  private rows: readonly string[] = []
  private pieces = 0

  constructor(private readonly changed: () => void) {}

  draw(pen: Pen, scene: GridScene, margin: boolean): void {
    const { context, view, size, density, palette } = pen
    if (context.path) {
      paintCells(context, placeOf(scene, view, size), scene, palette, margin, density)
      context.setTransform(density, 0, 0, density, 0, 0)
      return
    }
    const what = [
      scene.cell,
      radiusOf(scene),
      margin,
      palette.get('--wall'),
      scene.rows.length,
      columnsOf(scene),
      size.width,
      size.height,
      density,
    ].join()
    const where = [view.x, view.y, view.scale].join()
    const painted = this.rows !== scene.rows
    const moved = this.where !== where || painted
    const light = this.pieces <= HEAVY && (!painted || scene.rows.length * columnsOf(scene) <= LARGE)
    if (this.what !== what || (moved && light)) this.render(pen, scene, margin, what, where)
    else if (moved) this.soon()
    if (!this.canvas || !this.place || !this.size) return
    const now = placeOf(scene, view, size)
    const by = now.side / this.place.side
    const { width, height } = this.size
    context.drawImage(this.canvas, now.left - this.place.left * by, now.top - this.place.top * by, width * by, height * by)
    if (this.rows !== scene.rows) this.patch(pen, scene, now)
  }

  /** Cells that have changed since the picture was drawn; their margin follows at rest. */
  private patch({ context, palette }: Pen, { rows }: GridScene, { left, top, side }: Place): void {
    rows.forEach((line, row) => {
      const before = this.rows[row] ?? ''
      if (line === before) return
      for (let column = 0; column < line.length; column += 1) {
        if (line[column] === before[column]) continue
        context.fillStyle = palette.get(line[column] === '#' ? '--wall' : '--stage')
        context.fillRect(left + column * side, top + row * side, side, side)
      }
    })
  }

  private soon(): void {
    clearTimeout(this.rest)
    this.rest = setTimeout(() => {
      this.what = ''
      this.changed()
    }, REST)
  }

  private render(pen: Pen, scene: GridScene, margin: boolean, what: string, where: string): void {
    const { view, size, density, palette } = pen
    Object.assign(this, { what, where, size, rows: scene.rows, pieces: outlineOf(scene.rows, pen).pieces })
    const [width, height] = [Math.max(1, Math.round(size.width * density)), Math.max(1, Math.round(size.height * density))]
    this.canvas ??= new OffscreenCanvas(width, height)
    Object.assign(this.canvas, { width, height })
    this.place = placeOf(scene, view, size)
    const context = this.canvas.getContext('2d')
    if (context) paintCells(context, this.place, scene, palette, margin, density)
  }
}

function placeOf(scene: GridScene, view: View, size: Size): Place {
  const [left, top] = toScreen(view, size, [0, view.down ? 0 : scene.rows.length * scene.cell])
  return { left, top, side: scene.cell * view.scale }
}

function paintCells(
  context: Context,
  { left, top, side }: Place,
  scene: GridScene,
  palette: Palette,
  margin: boolean,
  density: number,
): void {
  const [columns, rows] = [columnsOf(scene), scene.rows.length]
  const { filled, edge } = outlineOf(scene.rows, { context })
  const pixel = 1 / side
  context.setTransform(density * side, 0, 0, density * side, density * left, density * top)
  context.save()
  context.beginPath()
  context.rect(0, 0, columns, rows)
  context.clip()
  context.lineCap = 'round'
  const reach = (2 * radiusOf(scene)) / scene.cell
  if (margin && reach * side > 1) {
    for (const [token, more] of [
      ['--margin-edge', 2 * pixel],
      ['--margin', 0],
    ] as const) {
      context.strokeStyle = palette.get(token)
      context.lineWidth = reach + more
      context.stroke(edge)
    }
    context.fillStyle = palette.get('--margin')
    context.fill(filled)
  }
  context.restore()
  context.fillStyle = palette.get('--wall')
  context.fill(filled)
  if (side >= LINES_FROM) lines(context, columns, rows, pixel, palette)
  context.strokeStyle = palette.get('--wall-edge')
  context.lineWidth = 1.25 * pixel
  if (side >= 3) context.stroke(edge)
}

function lines(context: Context, columns: number, rows: number, pixel: number, palette: Palette): void {
  context.beginPath()
  for (let column = 1; column < columns; column += 1) context.rect(column, 0, 0, rows)
  for (let row = 1; row < rows; row += 1) context.rect(0, row, columns, 0)
  context.strokeStyle = palette.get('--cell-line')
  context.lineWidth = pixel
  context.stroke()
}

/** The cell that will be painted. */
export function drawCell({ context, view, size, palette }: Pen, scene: GridScene, cell: Cell): void {
  const [x, y] = toScreen(view, size, middleOf(scene, cell))
  const side = Math.max(scene.cell * view.scale, 5)
  context.setLineDash([])
  context.lineWidth = 2
  context.strokeStyle = palette.get('--focus')
  context.strokeRect(x - side / 2, y - side / 2, side, side)
}
