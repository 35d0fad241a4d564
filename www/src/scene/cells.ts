import type { GridScene, Point } from 'forage-lab'

/** A cell of a grid; rows count from the top, as scene files list them. */
export interface Cell {
  column: number
  row: number
}

export type Side = 'length' | 'width'

const BLOCKED = '#'
const FREE = '.'

export const columnsOf = ({ rows }: GridScene): number => rows[0]?.length ?? 0

/** The distance that the robot's centre keeps from blocked cells. */
export const radiusOf = ({ robot }: GridScene): number => Math.hypot(robot?.length ?? 0, robot?.width ?? 0) / 2

export const isBlocked = ({ rows }: GridScene, { column, row }: Cell): boolean => rows[row]?.[column] === BLOCKED

/** How far below the top edge a point is. */
const depth = (scene: GridScene, y: number): number => (scene.y_axis === 'up' ? scene.rows.length * scene.cell - y : y)

/** The cell that a point lies in; nothing beyond the edges. */
export function cellAt(scene: GridScene, [x, y]: Point): Cell | null {
  const column = Math.floor(x / scene.cell)
  const row = Math.floor(depth(scene, y) / scene.cell)
  const inside = column >= 0 && row >= 0 && column < columnsOf(scene) && row < scene.rows.length
  return inside ? { column, row } : null
}

export const middleOf = (scene: GridScene, { column, row }: Cell): Point => [
  (column + 0.5) * scene.cell,
  depth(scene, (row + 0.5) * scene.cell),
]

/** A cell's number in fields: row by row, the row of the smallest y first. */
export const indexOf = (scene: GridScene, { column, row }: Cell): number =>
  (scene.y_axis === 'up' ? scene.rows.length - 1 - row : row) * columnsOf(scene) + column

/** The same grid with no cell blocked. */
export const cleared = (scene: GridScene): GridScene => ({ ...scene, rows: scene.rows.map((line) => FREE.repeat(line.length)) })

export const isClear = ({ rows }: GridScene): boolean => !rows.some((line) => line.includes(BLOCKED))

/** The cells on the way from one to another: a fast hand leaves no gaps. */
export function between(from: Cell, to: Cell): Cell[] {
  const steps = Math.max(Math.abs(to.column - from.column), Math.abs(to.row - from.row), 1)
  return Array.from({ length: steps + 1 }, (_, at) => ({
    column: Math.round(from.column + ((to.column - from.column) * at) / steps),
    row: Math.round(from.row + ((to.row - from.row) * at) / steps),
  }))
}

/** The same scene where nothing changes. */
export function paint(scene: GridScene, cells: readonly Cell[], block: boolean): GridScene {
  const changed = new Map<number, string[]>()
  for (const cell of cells) {
    if (isBlocked(scene, cell) === block) continue
    const line = changed.get(cell.row) ?? [...(scene.rows[cell.row] ?? '')]
    line[cell.column] = block ? BLOCKED : FREE
    changed.set(cell.row, line)
  }
  if (changed.size === 0) return scene
  return { ...scene, rows: scene.rows.map((line, row) => changed.get(row)?.join('') ?? line) }
}
