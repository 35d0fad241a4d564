import { texts } from '../texts'

/** Text of what is run: case, planner, scene and seed. */
export const setup = texts('setup', {
  case: 'Case',
  planner: 'Planner',
  scene: 'Scene',
  edited: (title: string) => `${title} (edited)`,
  kinds: { tour: 'Tours', grid: 'Grids', discs: 'Among discs', function: 'Test functions', arm: 'Arms in space' },
  see: 'What to see:',
  chooseCase: 'Choose one to run it',
  own: { title: 'Your own', function: 'A function …', random: 'A random scene …' },
  nothingFound: 'Nothing has these words. Try fewer.',
  families: {
    swarm: 'Swarms',
    ants: 'Ants',
    search: 'Searches',
    tour: 'Tours',
    tree: 'Trees',
    dynamic: 'Driving among moving obstacles',
    tuning: 'Tuning',
    own: 'Your own',
  } as Readonly<Record<string, string>>,
  seed: 'Seed',
  source: 'Source',
  seedHint: 'A whole number from 0 to 9 007 199 254 740 991.',
} as const)
