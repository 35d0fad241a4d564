import { texts } from '../texts'

/** Text about the run before a change. */
export const forks = texts('forks', {
  label: 'The run before the change',
  before: (value: string, iteration: string) => `before the change: ${value}, iteration ${iteration}`,
  undo: 'Undo',
  compare: 'Open both in Compare',
  /** The title of the planner with the code of before. */
  earlier: (planner: string) => `${planner} (before)`,
  noEarlier: 'The code of before could not be given another name: write the name right after register({ to compare the two.',
  otherScene: 'Their scenes are of different kinds.',
  dismiss: 'Hide the run before',
} as const)
