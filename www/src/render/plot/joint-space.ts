/** A tree's nodes, row by row: its parent (negative: none), which tree, and six angles in degrees. */
export interface Nodes {
  columns: readonly string[]
  rows: Float64Array
}

/** The angles that an axis shows, in degrees. */
export interface Span {
  min: number
  max: number
}

export interface Plot {
  /** In pixels. */
  width: number
  height: number
  /** The joints across and up, from 0. */
  across: number
  up: number
  /** One for each joint. */
  spans: readonly Span[]
}

export interface Colours {
  obstacle: string
  ink: string
  line: string
  tree: string
  goal: string
  path: string
  selected: string
  stage: string
}

export interface Marks {
  /** 1 where the arm touches something: rows of cells from the least angles on, as many as there are cells in a row. */
  touching: Uint8Array | null
  path: readonly (readonly number[])[]
  selected: number | null
  pointed: number | null
}

/** Room for the labels, in pixels. */
export const RIM = { left: 38, right: 8, top: 8, bottom: 22 }
const NODE = 2.6
/** So much of what is seen from near is left free about it, and so many degrees are seen at least. */
const [MARGIN, LEAST] = [0.08, 10]

export const count = ({ columns, rows }: Nodes): number => (columns.length > 0 ? Math.floor(rows.length / columns.length) : 0)

/** A node's number in a column. */
export function told({ columns, rows }: Nodes, name: string, node: number): number {
  const column = columns.indexOf(name)
  return column < 0 ? NaN : (rows[node * columns.length + column] ?? NaN)
}

const share = (value: number, { min, max }: Span): number => (max > min ? (value - min) / (max - min) : 0.5)

/** Where two angles are in the plot. */
function place({ width, height, across, up, spans }: Plot, x: number, y: number): [number, number] {
  const [a, b] = [spans[across], spans[up]]
  if (!a || !b) return [0, 0]
  return [RIM.left + share(x, a) * (width - RIM.left - RIM.right), height - RIM.bottom - share(y, b) * (height - RIM.top - RIM.bottom)]
}

const nameOf = (joint: number): string => `q${joint + 1}`

/** What each joint must show for all nodes and the path to be seen. */
export function around(nodes: Nodes, path: readonly (readonly number[])[]): Span[] {
  const all = count(nodes)
  return [0, 1, 2, 3, 4, 5].map((joint) => {
    let [min, max] = [Infinity, -Infinity]
    for (let node = 0; node < all; node += 1) {
      const angle = told(nodes, nameOf(joint), node)
      ;[min, max] = [Math.min(min, angle), Math.max(max, angle)]
    }
    for (const posture of path) [min, max] = [Math.min(min, posture[joint] ?? min), Math.max(max, posture[joint] ?? max)]
    const [middle, half] = [(min + max) / 2, Math.max((max - min) * (0.5 + MARGIN), LEAST / 2)]
    return min <= max ? { min: middle - half, max: middle + half } : { min: -180, max: 180 }
  })
}

/** Where each node is, x and y by turns. */
export function places(plot: Plot, nodes: Nodes): Float64Array {
  const found = new Float64Array(2 * count(nodes))
  const [across, up] = [nodes.columns.indexOf(nameOf(plot.across)), nodes.columns.indexOf(nameOf(plot.up))]
  const width = nodes.columns.length
  for (let node = 0; 2 * node < found.length; node += 1) {
    found.set(place(plot, nodes.rows[node * width + across] ?? NaN, nodes.rows[node * width + up] ?? NaN), 2 * node)
  }
  return found
}

/** The node that is nearest to a point, if it is near enough. */
export function nearest(at: Float64Array, x: number, y: number, reach: number): number | null {
  let [found, least] = [-1, reach * reach]
  for (let node = 0; 2 * node < at.length; node += 1) {
    const [dx, dy] = [(at[2 * node] ?? NaN) - x, (at[2 * node + 1] ?? NaN) - y]
    const away = dx * dx + dy * dy
    if (away <= least) [found, least] = [node, away]
  }
  return found < 0 ? null : found
}

/** Draws trees, path and marks in the plane of two joints. */
export function draw(context: CanvasRenderingContext2D, plot: Plot, nodes: Nodes, at: Float64Array, colours: Colours, marks: Marks): void {
  context.fillStyle = colours.stage
  context.fillRect(0, 0, plot.width, plot.height)
  if (marks.touching) drawTouching(context, plot, colours, marks.touching)
  drawFrame(context, plot, colours)
  const parent = nodes.columns.indexOf('parent')
  const tree = nodes.columns.indexOf('tree')
  const width = nodes.columns.length
  for (const which of [0, 1]) {
    const edges = new Path2D()
    const dots = new Path2D()
    for (let node = 0; 2 * node < at.length; node += 1) {
      if ((nodes.rows[node * width + tree] ?? 0) !== which) continue
      const [x, y] = [at[2 * node] ?? 0, at[2 * node + 1] ?? 0]
      dots.rect(x - NODE / 2, y - NODE / 2, NODE, NODE)
      const from = nodes.rows[node * width + parent] ?? -1
      if (!(from >= 0)) continue
      edges.moveTo(at[2 * from] ?? 0, at[2 * from + 1] ?? 0)
      edges.lineTo(x, y)
    }
    context.strokeStyle = context.fillStyle = which === 0 ? colours.tree : colours.goal
    context.lineWidth = 1
    context.setLineDash(which === 0 ? [] : [5, 2])
    context.globalAlpha = 0.7
    context.stroke(edges)
    context.globalAlpha = 1
    context.fill(dots)
  }
  context.setLineDash([])
  drawPath(context, plot, colours, marks.path)
  for (const [node, radius] of [
    [marks.pointed, 5],
    [marks.selected, 7],
  ] as const)
    if (node !== null) ring(context, at, node, radius, colours)
}

/** Stretches of a row are one rectangle. */
function drawTouching(context: CanvasRenderingContext2D, { width, height }: Plot, { obstacle }: Colours, cells: Uint8Array): void {
  const side = Math.round(Math.sqrt(cells.length))
  const [wide, high] = [(width - RIM.left - RIM.right) / side, (height - RIM.top - RIM.bottom) / side]
  const areas = new Path2D()
  for (let row = 0; row < side; row += 1) {
    for (let from = 0, to = 0; from < side; from = to + 1) {
      to = from
      while (to < side && cells[row * side + to] === 1) to += 1
      if (to > from) areas.rect(RIM.left + from * wide, height - RIM.bottom - (row + 1) * high, (to - from) * wide, high + 0.5)
    }
  }
  context.fillStyle = obstacle
  context.fill(areas)
}

const whole = (angle: number): string => `${Math.round(angle)}°`.replace('-', '−')

/** What is labelled between the ends: zero, if it is well within. */
function inner({ min, max }: Span): number {
  const near = 0.15 * (max - min)
  return min + near < 0 && max - near > 0 ? 0 : (min + max) / 2
}

function drawFrame(context: CanvasRenderingContext2D, plot: Plot, { line, ink }: Colours): void {
  const { width, height, across, up, spans } = plot
  context.strokeStyle = line
  context.lineWidth = 1
  context.setLineDash([])
  context.strokeRect(RIM.left + 0.5, RIM.top + 0.5, width - RIM.left - RIM.right - 1, height - RIM.top - RIM.bottom - 1)
  const [a, b] = [spans[across], spans[up]]
  if (!a || !b) return
  context.fillStyle = ink
  context.textBaseline = 'top'
  for (const [value, align] of [
    [a.min, 'left'],
    [inner(a), 'center'],
    [a.max, 'right'],
  ] as const) {
    const [x] = place(plot, value, b.min)
    context.textAlign = align
    context.fillText(whole(value), x, height - RIM.bottom + 5)
  }
  context.textAlign = 'right'
  for (const [value, baseline] of [
    [b.min, 'bottom'],
    [inner(b), 'middle'],
    [b.max, 'top'],
  ] as const) {
    const [, y] = place(plot, a.min, value)
    context.textBaseline = baseline
    context.fillText(whole(value), RIM.left - 5, y)
  }
}

function drawPath(context: CanvasRenderingContext2D, plot: Plot, { path: colour, stage }: Colours, postures: Marks['path']): void {
  const line = new Path2D()
  postures.forEach((posture, at) => {
    const [x, y] = place(plot, posture[plot.across] ?? NaN, posture[plot.up] ?? NaN)
    if (at === 0) line.moveTo(x, y)
    else line.lineTo(x, y)
  })
  context.lineJoin = 'round'
  for (const [style, width] of [
    [stage, 5],
    [colour, 2.5],
  ] as const) {
    context.strokeStyle = style
    context.lineWidth = width
    context.stroke(line)
  }
}

function ring(context: CanvasRenderingContext2D, at: Float64Array, node: number, radius: number, { selected, stage }: Colours): void {
  for (const [style, width] of [
    [stage, 5],
    [selected, 2.25],
  ] as const) {
    context.beginPath()
    context.arc(at[2 * node] ?? -99, at[2 * node + 1] ?? -99, radius, 0, 2 * Math.PI)
    context.strokeStyle = style
    context.lineWidth = width
    context.stroke()
  }
}
