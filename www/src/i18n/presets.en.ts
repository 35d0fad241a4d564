/** Text about cases that were published: loaded beside the choice of planners and scenes. */
export const presets = {
  choose: 'Choose one to run it',
  see: 'What to see:',
  cases: {
    'moving-ants': {
      title: '[WOLF-ANT] §5.3: one moving obstacle',
      see: 'Ants find a way of the published length. On it the robot foresees that the disc comes too near, and goes round it along the pheromone; the log tells when and why.',
    },
    'moving-a-star': {
      title: '[WOLF-ANT] §5.3, with A*',
      see: 'The same drive on an exact way: soon after it sets out the robot foresees that the disc comes too near, and plans a new way to the goal.',
    },
    'moving-d-star-lite': {
      title: '[WOLF-ANT] §5.3, with D* Lite',
      see: 'The same drive on another of the shortest ways: the disc is seen, and nothing has to be decided.',
    },
    crossing: {
      title: 'Cross traffic',
      see: 'Discs cross a hall from both sides: each detour is a decision with a time, a place and a reason.',
    },
    patrol: {
      title: 'Guards on patrol',
      see: 'Where a guard stands in a door there is no way round: the robot waits until the way is clear.',
    },
    corridor: {
      title: 'A corridor with niches',
      see: 'Neither a way round nor standing still is safe: the robot backs into a niche and lets the disc pass.',
    },
    wolves: {
      title: '[WOLF-ANT] §5.1: wolves’ shares',
      see: 'How early the pheromone gathers on a shortest way over the cells; the published length is 562.8427 px.',
    },
    direction: {
      title: '[ANTBAT] §3.1: ants with direction',
      see: 'Ants that mind where the goal lies are on a shortest way within a few iterations.',
    },
    bats: {
      title: '[ANTBAT] §3.3: bats and twelve stops',
      see: 'First ants build the roads between the stops, then bats put the stops in order; the timeline has a part for each.',
    },
    quantum: {
      title: '[LTQPSO] §4: ten metres of walls',
      see: 'Particles leap about their attractors, less far as the run goes on; the robot can drive along the result.',
    },
    hens: {
      title: '[WCPSO] §3.2: seven discs',
      see: 'Hens and chicks shake a swarm that no longer improves; the exact optimum is 12.1416.',
    },
  },
} as const
