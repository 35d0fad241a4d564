import { type Context, type Path, pathOf } from './pen'

/** Blocked cells as shapes, in cells from the top left corner. */
export interface Outline {
  /** All blocked cells, in as few rectangles as a sweep finds. */
  filled: Path
  /** Where blocked meets free, in as few lines as possible. */
  edge: Path
  /** How many pieces these are made of. */
  pieces: number
}

const known = new WeakMap<readonly string[], Outline>()

/** The shapes of these rows, to be drawn here; rows are never changed in place. */
export function outlineOf(rows: readonly string[], on: { context: Context }): Outline {
  // A file has paths of its own.
  if (on.context.path) return trace(rows, () => pathOf(on))
  const found = known.get(rows) ?? trace(rows, () => pathOf(on))
  known.set(rows, found)
  return found
}

function trace(rows: readonly string[], begin: () => Path): Outline {
  const filled = begin()
  const edge = begin()
  let pieces = 0
  const columns = rows[0]?.length ?? 0
  const cells = padded(rows, columns)
  const blocked = (column: number, row: number): boolean => cells[(row + 1) * (columns + 2) + column + 1] === 1

  // Runs of a row grow down for as long as the next row has the same run.
  let open = new Map<string, { from: number; to: number; top: number }>()
  for (let row = 0; row <= rows.length; row += 1) {
    const next: typeof open = new Map()
    for (const [from, to] of runs(columns, (column) => blocked(column, row))) {
      const key = `${from} ${to}`
      next.set(key, open.get(key) ?? { from, to, top: row })
      open.delete(key)
    }
    for (const { from, to, top } of open.values()) filled.rect(from, top, to - from, row - top)
    pieces += open.size
    open = next
  }

  const line = (x0: number, y0: number, x1: number, y1: number): void => {
    edge.moveTo(x0, y0)
    edge.lineTo(x1, y1)
    pieces += 1
  }
  for (let row = 0; row <= rows.length; row += 1) {
    for (const [from, to] of runs(columns, (column) => blocked(column, row - 1) !== blocked(column, row))) line(from, row, to, row)
  }
  for (let column = 0; column <= columns; column += 1) {
    for (const [from, to] of runs(rows.length, (row) => blocked(column - 1, row) !== blocked(column, row))) line(column, from, column, to)
  }
  return { filled, edge, pieces }
}

/** 1 where a cell is blocked, with a border of free ones. */
function padded(rows: readonly string[], columns: number): Uint8Array {
  const cells = new Uint8Array((columns + 2) * (rows.length + 2))
  rows.forEach((line, row) => {
    for (let column = line.indexOf('#'); column >= 0; column = line.indexOf('#', column + 1))
      cells[(row + 1) * (columns + 2) + column + 1] = 1
  })
  return cells
}

/** Stretches [from, to) in which something holds. */
function runs(count: number, holds: (at: number) => boolean): [number, number][] {
  const found: [number, number][] = []
  for (let at = 0; at < count; at += 1) {
    if (!holds(at)) continue
    const from = at
    while (at < count && holds(at)) at += 1
    found.push([from, at])
  }
  return found
}
