import { texts } from '../texts'

/** Text of what is compared: planners, scene, seeds and budget. */
export const compare = texts('compare', {
  lead: 'The same scene and the same number of evaluations for all: once side by side, or with many seeds as statistics.',
  as: { label: 'How to look at it', titles: { watch: 'Watch', statistics: 'Statistics' } },
  address: (why: string) => `Not all of this address could be opened. ${why}`,
  broken: (message: string) => `A worker failed (${message}). Try again.`,
  joined: (scene: string) => `None of the planners runs on “${scene}”; planners that do were added.`,
  /** Which optimum a planner is measured by. */
  references: {
    'any-angle': 'any-angle optimum',
    cells: 'optimum over cells',
    matrix: 'shortest tour',
    stored: 'optimum stated in the scene file',
  },
  plan: {
    title: 'What is compared',
    scene: 'Scene',
    here: (title: string) => `${title} (edited)`,
    maps: 'A random scene for each seed',
    mapsHelp: 'Seed 7 uses the generator’s scene 7. Runs are compared by how far they are above the exact optimum of their scene.',
    mapSettings: 'Parameters of the scenes',
    mapsOf: (title: string) => `${title}: one for each seed`,
    ownScenes: 'Made here',
    fromStage: (title: string) => `${title} (from the Lab)`,
    task: 'Task',
    tasks: { path: 'Path', tour: 'Tour', tuning: 'Tuning' },
    seed: 'Seed',
    from: 'First seed',
    count: 'Number of seeds',
    budget: 'Budget',
    equal: 'Equal evaluations',
    own: 'Own iterations',
    evaluations: 'Evaluations',
    firstHelp: 'As many evaluations as the first planner takes with its own iterations. An iteration that has begun is finished.',
    equalHelp: 'Each planner stops at this number of evaluations. An iteration that has begun is finished.',
    evaluation: (what: string) => `An evaluation is ${what}.`,
    evaluationDiffers: (things: readonly [what: string, planners: readonly string[]][]) =>
      `Evaluations are of different kinds: ${things.map(([what, planners]) => `${what} (${planners.join(', ')})`).join('; ')}.`,
    watchHelp: 'At each tick you see every planner’s first iteration that has used them up.',
    ownHelp: 'Each planner runs as many iterations as it is set to: evaluations differ.',
  },
  fields: {
    whole: (name: string, typed: string, least: string, most: string) =>
      `${name}: “${typed}” is not allowed; it takes a whole number from ${least} to ${most}.`,
    wholeOrNothing: (name: string, typed: string, least: string, most: string) =>
      `${name}: “${typed}” is not allowed; it takes a whole number from ${least} to ${most}, or nothing.`,
  },
  entrants: {
    title: 'Planners',
    before: 'before the edit',
    add: 'Add a planner',
    choose: 'Planner to add',
    full: 'At most eight planners.',
    none: 'Add a planner to compare.',
    parameters: 'Parameters',
    parametersOf: (name: string) => `Parameters of ${name}`,
    copy: 'Duplicate',
    copyOf: (name: string) => `Duplicate ${name}, to give it other parameters`,
    remove: (name: string) => `Remove ${name}`,
    restore: (name: string) => `Put ${name} back`,
    unsuited: (scene: string) => `It does not run on “${scene}” and is left out.`,
    otherTask: 'It has another task and is left out.',
    double: 'The same as one before it: give it other parameters, or it is left out.',
    done: 'Done',
  },
  presets: {
    title: 'Ready-made comparisons',
    all: {
      swarms: {
        title: 'Four swarms among discs',
        help: 'WCPSO, which perturbs stagnating particles, and three other swarms on the scene of its paper.',
      },
      inertia: {
        title: 'Three inertia weights',
        help: 'One planner on Rastrigin’s function with w = 0.4, 0.6 and 0.8: small values get stuck.',
      },
      bbob: {
        title: 'A function of the suite bbob',
        help: 'Rastrigin’s function in 10 variables, shifted, rotated and distorted: 15 instances, 1,000 evaluations for each variable.',
      },
      shifted: {
        title: 'Centre bias',
        help: 'Rastrigin’s function in 10 variables with its minimum anywhere in the search box: what does a planner lose that searches near the centre?',
      },
      quantum: { title: 'Quantum swarms', help: 'Does the evolving swarm go farther than the plain quantum swarm?' },
      ants: { title: 'Four colonies', help: 'Which rule finds the shortest path, and how soon?' },
      maps: {
        title: 'Colonies on 100 random maps',
        help: 'A map of rooms for each seed: which colony finds a path on every map, and how large is its gap?',
      },
      exact: { title: 'Exact searches', help: 'The same optimum; how many cells does each look at?' },
      tours: {
        title: 'Tours through 52 stops',
        help: 'Bat algorithm, genetic algorithm, PSO and simulated annealing with equal evaluations.',
      },
      trees: { title: 'Trees among discs', help: 'One tree, two trees, and one that rewires itself.' },
      arm: { title: 'An arm’s trees', help: 'Six joints around a cuboid: what does a guide save?' },
      drives: { title: 'Driving among moving obstacles', help: 'Three replanning methods among moving obstacles.' },
    },
  },
} as const)
