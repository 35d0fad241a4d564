import type { Point, Scene } from 'forage-lab'
import { moving as text } from '../locales/en/moving'
import { number } from '../text/number'
import { type Cell, columnsOf, middleOf } from './cells'

/** The path that a paper prints cell by cell, through the centres of its cells, as a layer; null where a scene's file holds none. */
export function printedPath(scene: Scene): { path: Point[]; title: string; help: string } | null {
  const cells = scene.published?.path_cells
  if (scene.kind !== 'grid' || !Array.isArray(cells)) return null
  const columns = columnsOf(scene)
  // They count from the row of the smallest y, as the core does.
  const cellOf = (number: number): Cell => {
    const rows = Math.floor(number / columns)
    return { column: number % columns, row: scene.y_axis === 'up' ? scene.rows.length - 1 - rows : rows }
  }
  const isCell = (number: unknown): number is number =>
    Number.isInteger(number) && Number(number) >= 0 && Number(number) < columns * scene.rows.length
  if (cells.length === 0 || !cells.every(isCell)) return null
  const path = cells.map((number) => middleOf(scene, cellOf(number)))
  return { path, title: text.printed, help: text.printedHelp(number(lengthOf(path), 7)) }
}

export const lengthOf = (path: readonly Point[]): number =>
  path.reduce((sum, [x, y], at) => {
    const [fromX, fromY] = path[at - 1] ?? [x, y]
    return sum + Math.hypot(x - fromX, y - fromY)
  }, 0)
