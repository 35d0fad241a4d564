import type { GridScene, Point } from 'forage-lab'
import type { Side } from './cells'
import { rounded } from './edits'
import { movingOf, placed, withMoving } from './moving'

/** Everything grows with the cells: start, goal and stops stay in theirs, and obstacles go from one to the next in the same time. */
export function rescale(scene: GridScene, cell: number): GridScene {
  const factor = cell / scene.cell
  if (!Number.isFinite(factor) || factor <= 0) return { ...scene, cell }
  const grown = ([x, y]: Point): Point => [rounded(x * factor), rounded(y * factor)]
  const { start, goal, stops } = scene
  const wider = {
    ...scene,
    cell,
    ...(start && { start: grown(start) }),
    ...(goal && { goal: grown(goal) }),
    ...(stops && { stops: stops.map(grown) }),
  }
  if (movingOf(scene).length === 0) return wider
  return withMoving(wider, (all) =>
    all.map((one) => ({
      ...placed(one, grown),
      radius: rounded(one.radius * factor),
      ...(one.velocity && { velocity: grown(one.velocity) }),
    })),
  )
}

/** A robot with one side has both: the other is as long until it is given. */
export function resizeRobot(scene: GridScene, side: Side, value: number): GridScene {
  const { robot } = scene
  const other = side === 'length' ? 'width' : 'length'
  return { ...scene, robot: { ...robot, [other]: robot?.[other] ?? value, [side]: value } }
}
