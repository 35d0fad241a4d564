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
    'arm-guided': {
      title: '[ARM-RRT] §4: guided tree, no obstacle',
      see: 'The tree runs nearly straight to the goal. Click a node to see its twenty samples, the four that were kept and what the roulette wheel chose.',
    },
    'arm-guided-wide': {
      title: '[ARM-RRT] §4: guided, step 0.05',
      see: 'The same with longer steps: fewer nodes, and the end comes sooner.',
    },
    'arm-basic': {
      title: '[ARM-RRT] §4: basic tree, no obstacle',
      see: 'A basic tree fills the workspace before it comes to the goal; compare the number of nodes with the guided one’s.',
    },
    'arm-cuboid': {
      title: '[ARM-RRT] §4: guided tree and a cuboid',
      see: 'The tree slides along the cuboid. Let the arm follow the path: the verdict is of the whole arm, not of its tip alone.',
    },
    'arm-cuboid-basic': {
      title: '[ARM-RRT] §4: basic tree and a cuboid',
      see: 'The basic tree goes everywhere: more nodes and a longer raw path, and hardly longer after it was shortened.',
    },
    'arm-star': {
      title: 'RRT* around the cuboid',
      see: 'The first path comes soon; then the tree is rewired, and the path comes near to the tip’s shortest way.',
    },
    'arm-joints': {
      title: 'RRT-Connect in the six joints',
      see: 'The way it is done today: two trees of postures, and the whole arm keeps clear. The same tree is shown in pairs of joints and in space.',
    },
    'arm-puma': {
      title: 'Another arm: PUMA 560',
      see: 'A common arm with a spherical wrist, given as data alone: its postures, its motion and where its tip can come follow from the table.',
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
