import type { Point, Scene } from 'forage-lab'
import { type Cell, columnsOf, middleOf } from './cells'

/** The path that a paper prints cell by cell, through the centres of its cells; empty where a scene's file holds none. */
export function printedPath(scene: Scene | null): Point[] {
  const cells = scene?.published?.path_cells
  if (scene?.kind !== 'grid' || !Array.isArray(cells)) return []
  const columns = columnsOf(scene)
  // They count from the row of the smallest y, as the core does.
  const cellOf = (number: number): Cell => {
    const rows = Math.floor(number / columns)
    return { column: number % columns, row: scene.y_axis === 'up' ? scene.rows.length - 1 - rows : rows }
  }
  const isCell = (number: unknown): number is number =>
    Number.isInteger(number) && Number(number) >= 0 && Number(number) < columns * scene.rows.length
  return cells.every(isCell) ? cells.map((number) => middleOf(scene, cellOf(number))) : []
}

export const lengthOf = (path: readonly Point[]): number =>
  path.reduce((sum, [x, y], at) => {
    const [fromX, fromY] = path[at - 1] ?? [x, y]
    return sum + Math.hypot(x - fromX, y - fromY)
  }, 0)
