/** Text about the run before a change. */
export const forks = {
  label: 'The run before the change',
  before: (value: string, iteration: string) => `before the change: ${value}, iteration ${iteration}`,
  undo: 'Undo',
  compare: 'Open both in Compare',
  otherScene: 'They are on different scenes.',
  dismiss: 'Hide the run before',
} as const
