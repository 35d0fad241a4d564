import type { Planner, Scene } from 'forage-lab'
import { stopsOf, suits } from '../scene/stops'

/** Whether a planner can be run on a scene as it is: some can do with so many stops only. */
export const canRun = (planner: Planner, scene: Scene): boolean =>
  suits(planner, scene) && (!planner.stops || planner.most_stops === undefined || stopsOf(scene).length <= planner.most_stops)
