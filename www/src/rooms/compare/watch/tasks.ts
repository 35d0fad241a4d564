import type { Catalogue, Planner, Scene } from 'forage-lab'
import { canRun } from '../../../catalogue/suitability'

/** What is looked for: a way from start to goal (or a function's minimum), or a tour through stops. One can't be measured by the other. */
export type Task = 'path' | 'tour'

export const taskOf = ({ stops }: Planner): Task => (stops ? 'tour' : 'path')

/** An evaluation of a planner that tunes another is a whole run: it has no place among equals. */
const tunes = ({ family }: Planner): boolean => family === 'tuning'

/** The planners that can race on a scene. */
export const able = (catalogue: Catalogue | null, scene: Scene): readonly Planner[] =>
  catalogue?.planners.filter((planner) => canRun(planner, scene) && !tunes(planner)) ?? []

/** Those that can do a task there. */
export const fitting = (catalogue: Catalogue | null, scene: Scene, task: Task): readonly Planner[] =>
  able(catalogue, scene).filter((planner) => taskOf(planner) === task)

/** What can be raced for on a scene. */
export const tasksOn = (catalogue: Catalogue | null, scene: Scene): Task[] => [...new Set(able(catalogue, scene).map(taskOf))].sort()
