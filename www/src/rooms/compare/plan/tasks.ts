import type { Catalogue, Planner, Scene } from 'forage-lab'
import { canRun } from '../../../catalogue/suitability'

/** What is looked for: a way from start to goal (or a function's minimum), a tour through stops, or parameters of another planner. One can't be measured by the other. */
export type Task = 'path' | 'tour' | 'tuning'

/** Of a planner that tunes another, an evaluation is a whole run. */
export const taskOf = ({ stops, family }: Planner): Task => (family === 'tuning' ? 'tuning' : stops ? 'tour' : 'path')

/** The planners that run on a scene. */
const able = (catalogue: Catalogue | null, scene: Scene): readonly Planner[] =>
  catalogue?.planners.filter((planner) => canRun(planner, scene)) ?? []

/** Those that can do a task there. */
export const fitting = (catalogue: Catalogue | null, scene: Scene, task: Task): readonly Planner[] =>
  able(catalogue, scene).filter((planner) => taskOf(planner) === task)

/** What there is to do on a scene. */
export const tasksOn = (catalogue: Catalogue | null, scene: Scene): Task[] => [...new Set(able(catalogue, scene).map(taskOf))].sort()
