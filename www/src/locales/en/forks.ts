/** Text about the run before a change. */
export const forks = {
  label: 'The run before the change',
  before: (value: string, iteration: string) => `before the change: ${value}, iteration ${iteration}`,
  undo: 'Undo',
  compare: 'Open both in Compare',
  /** The title of the planner with the code of before. */
  earlier: (planner: string) => `${planner} (before)`,
  otherScene: 'Their scenes are of different kinds.',
  dismiss: 'Hide the run before',
} as const
