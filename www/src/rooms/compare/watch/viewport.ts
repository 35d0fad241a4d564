import type { Point, Scene } from 'forage-lab'
import { type Box, extent, fit, isDown, pan, type Size, type View, zoom } from '../../../render/view'
import type { Race } from './race.svelte'
import { SIDES } from '../../../render/space/orbit'
import { flattened } from '../../../render/space/projection'

/** Left free about a scene in a lane, in pixels. */
const MARGINS: Point = [30, 28]

/** What is to be seen: of an arm's scene, what a side shows. */
function boxOf({ lanes, side }: Race, scene: Scene): Box {
  if (scene.kind !== 'arm') return extent(scene)
  return flattened(scene, lanes.find(({ run }) => run)?.run?.skeleton ?? [], SIDES[side]).bounds
}

/** All of the scene, in all lanes. */
export const whole = (race: Race, scene: Scene, size: Size): View => fit(boxOf(race, scene), size, MARGINS, isDown(scene))

export function showAll(race: Race): void {
  race.view = null
}

export function panBy(race: Race, view: View, dx: number, dy: number): void {
  race.view = pan(view, dx, dy)
}

export function zoomBy(race: Race, by: number, scene: Scene, size: Size, view: View, at: Point = [size.width / 2, size.height / 2]): void {
  race.view = zoom(view, size, by, at, whole(race, scene, size).scale)
}
