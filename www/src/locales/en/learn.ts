import { texts } from '../texts'

/** Text of the room where a newcomer begins. */
export const learn = texts('learn', {
  title: 'A swarm looks for the shortest way',
  lead: 'Each line is a particle: it remembers its best way, and hears of the best of all.',
  prompt: 'Drag a disc',
  dragged: 'The swarm begins again',
  why: 'Why? See the numbers in the Lab',
  open: 'Open in the Lab',
  families: {
    title: 'Six ways to find a way',
    open: (title: string) => `${title}: run it in the Lab`,
    all: {
      swarm: { title: 'Swarms', text: 'Particles that follow their own best and the best of all.' },
      ants: { title: 'Ants', text: 'Many short trails; what is walked most smells strongest.' },
      bats: { title: 'Bats', text: 'A round trip through 52 stops, reordered by echo.' },
      tree: { title: 'Trees', text: 'Branches grow into free space and rewire themselves.' },
      moving: { title: 'Moving obstacles', text: 'A robot that plans again when something crosses its way.' },
      arm: { title: 'Arms', text: 'Six joints find their way around a cuboid.' },
    },
  },
  papers: {
    title: 'The five papers behind it',
    text: 'What they claim, and what comes out when it is run again.',
    open: 'See the papers',
  },
  unknown: (name: string) => `There is no lesson “${name}”.`,
  loading: 'Loading the lesson …',
} as const)
