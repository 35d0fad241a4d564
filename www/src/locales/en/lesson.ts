/** Text of lessons: what is around their own words. */
export const lesson = {
  lessons: 'Lessons',
  lead: 'Each takes about ten minutes. You predict first; the core says what comes out.',
  minutes: (n: number) => `${n} minutes`,
  steps: (n: number) => (n === 1 ? '1 step' : `${n} steps`),
  readTo: (step: number, all: number) => `Read to step ${step} of ${all}`,
  done: 'Read to the end',
  begin: 'Begin',
  goOn: 'Go on',
  forget: 'Delete my progress',
  forgotten: 'Your progress is deleted',
  kept: 'Your progress is kept in this browser only.',
  unknown: (name: string) => `There is no lesson “${name}”.`,
  loading: 'Loading the lesson …',
  close: 'All lessons',
  goals: 'After this lesson you can',
  notes: 'Notes for the lecturer',
  next: 'Next',
  back: 'Back',
  place: (step: number, all: number) => `Step ${step} of ${all}`,
  stepsLabel: 'Steps of the lesson',
  stage: 'The run that the step shows',
  away: {
    forked: 'This is your own run now.',
    moved: 'You are elsewhere in the run.',
    back: 'Back to the lesson',
    lab: 'Open in the Lab',
  },
  change: 'Change the parameters',
  experiment: 'An experiment',
  compare: 'Open in Compare',
  task: 'A task',
  question: 'Predict',
  answer: 'This is my prediction',
  retry: 'Predict again',
  finding: 'The core computes the answer …',
  failed: (reason: string) => `There is no answer: ${reason}`,
  how: {
    arrow: 'Drag the tip of the arrow, or move it with the arrow keys.',
    cell: 'Click a neighbour of the cell, or choose it with the arrow keys.',
    member: 'Click one of them, or go to it with the arrow keys.',
    node: 'Click a node of the tree, or choose it with the arrow keys.',
  },
  layer: {
    arrow: 'Your prediction: the tip of the arrow',
    cell: 'Your prediction: a neighbour cell',
    member: 'Your prediction: one of them',
    node: 'Your prediction: a node',
  },
  tip: (x: string, y: string) => `The arrow ends at ${x}, ${y}.`,
  chosenMember: (index: number) => `Number ${index}.`,
  chosenNode: (n: number) => `Node ${n}.`,
  /** By how near a prediction was. */
  grades: { right: 'As you predicted', near: 'Nearly', off: 'It went otherwise' },
  feedback: {
    arrow: (off: string, length: string, angle: string) =>
      `Your arrow ends ${off} from where it went. The move is ${length} long; your angle is off by ${angle}°.`,
    cell: (direction: string, chosen: string, best: string, likeliest: string) =>
      direction === best
        ? `You chose ${direction}, the likeliest step: ${chosen}.`
        : `You chose ${direction}: ${chosen}. The likeliest step is ${best}: ${likeliest}.`,
    node: (chosen: string, nearest: string) => `Your node is ${chosen} from the sample, the nearest one ${nearest}.`,
    member: (index: number, value: string, rank: number, best: number, smallest: string) =>
      rank === 1
        ? `You chose number ${index}: with ${value} it has the smallest value.`
        : `You chose number ${index}: with ${value} it is in place ${rank}. Number ${best} has the smallest value: ${smallest}.`,
    option: (chosen: string, came: string) => (chosen === came ? `You chose “${came}”.` : `You chose “${chosen}”. It is: “${came}”.`),
    value: (of: string, value: string) => `${of}: ${value}.`,
    run: (of: string, value: string, iteration: number) => `${of} at iteration ${iteration}: ${value}.`,
    seeds: (of: string, value: string, agree: number, seeds: number) =>
      `${of}, median of ${seeds} seeds: ${value}. ${agree} of ${seeds} runs come to this option.`,
    compared: (of: string, seeds: number) => `${of}, median of ${seeds} seeds each`,
    wins: (n: number, seeds: number) => `best with ${n} of ${seeds} seeds`,
  },
  measures: {
    cost: 'cost',
    length: 'length',
    gap: 'gap to the exact optimum',
    evaluations: 'evaluations',
    iterations: 'iterations',
  } as Readonly<Record<string, string>>,
} as const
