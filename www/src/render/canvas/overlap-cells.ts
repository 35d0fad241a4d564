import type { GridScene, Point } from 'forage-lab'
import { cellAt, columnsOf, isBlocked, radiusOf } from '../../scene/cells'
import type { Pen } from './pen'
import { toScreen } from '../view'
import { TOUCH, WRONG } from './overlap'

/** Where the way goes in or out is found to a fraction of a step. */
const HALVINGS = 5
/** The most steps along a result. */
const STEPS = 4000

/** Whatever part of the result comes nearer to a blocked cell than the robot may is drawn in red. */
export function insideCells(pen: Pen, scene: GridScene, path: readonly Point[]): void {
  const { context, view, size } = pen
  const length = path.reduce((sum, at, index) => sum + distance(path[index - 1] ?? at, at), 0)
  const step = Math.max(1.5 / view.scale, radiusOf(scene) / 8, length / STEPS)
  const touch = TOUCH / view.scale
  context.beginPath()
  const draw = (from: Point, to: Point): void => {
    context.moveTo(...toScreen(view, size, from))
    context.lineTo(...toScreen(view, size, to))
  }
  path.slice(1).forEach((to, index) => {
    const from = path[index] ?? to
    const count = Math.max(1, Math.ceil(distance(from, to) / step))
    const at = (k: number): Point => [from[0] + ((to[0] - from[0]) * k) / count, from[1] + ((to[1] - from[1]) * k) / count]
    const wrong = (k: number): boolean => tooNear(scene, at(k), touch)
    let entered = wrong(0) ? 0 : null
    for (let k = 1; k <= count; k += 1) {
      const now = wrong(k)
      if (now && entered === null) entered = border(k - 1, k, wrong)
      if (!now && entered !== null) {
        draw(at(entered), at(border(k, k - 1, wrong)))
        entered = null
      }
    }
    if (entered !== null) draw(at(entered), to)
  })
  context.setLineDash([])
  context.lineCap = 'round'
  context.lineWidth = WRONG.width
  context.strokeStyle = pen.palette.get(WRONG.color)
  context.stroke()
}

const distance = (a: Point, b: Point): number => Math.hypot(b[0] - a[0], b[1] - a[1])

/** Where between right and wrong it begins to be wrong. */
function border(right: number, wrong: number, isWrong: (k: number) => boolean): number {
  for (let halving = 0; halving < HALVINGS; halving += 1) {
    const middle = (right + wrong) / 2
    if (isWrong(middle)) wrong = middle
    else right = middle
  }
  return wrong
}

/** Whether the robot's centre is nearer to a blocked cell than its radius, by more than `touch`. */
export function tooNear(scene: GridScene, at: Point, touch: number): boolean {
  const radius = radiusOf(scene) - touch
  const here = cellAt(scene, at)
  if (here && isBlocked(scene, here)) return radiusOf(scene) > 0 || deepIn(scene, at, touch)
  if (radius <= 0) return false
  const { cell } = scene
  const fromTop = scene.y_axis === 'up' ? scene.rows.length * cell - at[1] : at[1]
  const [x, y, reach] = [at[0] / cell, fromTop / cell, radius / cell]
  for (let row = Math.max(0, Math.floor(y - reach)); row <= Math.min(scene.rows.length - 1, Math.floor(y + reach)); row += 1) {
    const dy = Math.max(row - y, 0, y - row - 1)
    for (let column = Math.max(0, Math.floor(x - reach)); column <= Math.min(columnsOf(scene) - 1, Math.floor(x + reach)); column += 1) {
      const dx = Math.max(column - x, 0, x - column - 1)
      if (dx * dx + dy * dy < reach * reach && isBlocked(scene, { column, row })) return true
    }
  }
  return false
}

/** A point robot may touch a blocked cell's rim. */
function deepIn(scene: GridScene, [x, y]: Point, touch: number): boolean {
  const around: Point[] = [
    [x - touch, y],
    [x + touch, y],
    [x, y - touch],
    [x, y + touch],
  ]
  return around.every((at) => {
    const cell = cellAt(scene, at)
    return cell === null || isBlocked(scene, cell)
  })
}
