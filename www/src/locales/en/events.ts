import { texts } from '../texts'

/** Text about what happens in simulated time: loaded with the first run that tells of any. */
export const events = texts('events', {
  rail: 'Events on the timeline',
  when: (time: string, iteration: string) => `${time} s, iteration ${iteration}`,
  seconds: (time: string) => `${time} s`,
  obstacle: (n: string) => `obstacle ${n}`,
  /** Of those that happened nearly at once: how many more there are beside the one that is told. */
  more: (count: string) => (count === '1' ? 'and 1 more' : `and ${count} more`),
  together: (count: string) => `${count} events`,
  later: 'later',
  said: (title: string, time: string, reason: string) => `${title} at ${time} seconds. ${reason}`,
  tones: { plain: 'note', warning: 'warning', decision: 'decision', good: 'success', bad: 'alarm' },
  log: {
    none: 'Nothing has happened yet.',
    keys: 'On the stage and the timeline, N and Shift N lead to the next and the previous event.',
    list: 'Events in their order; Enter jumps there',
    filter: 'Which events are listed',
    /** Those that must not happen are always listed. */
    only: (title: string, count: string) => `${title}: ${count}`,
    hidden: (count: string) => (count === '1' ? '1 event is not listed.' : `${count} events are not listed.`),
    all: 'List all',
    copy: 'Copy as CSV',
    copied: 'Copied',
    failed: 'Copying was not allowed.',
    csv: 'Save as CSV',
  },
  fate: {
    collisions: (count: string) => (count === '1' ? '1 collision' : `${count} collisions`),
    arrived: 'Arrived without collision',
    arrivedAfter: (time: string) => `Arrived without collision after ${time} s`,
    arrivedStruck: (count: string) => `Arrived, but with ${count}`,
    lost: 'Did not arrive',
    touches: 'Arrived, but not collision-free',
    underway: 'No collision so far',
    struckUnderway: (count: string) => `${count} so far`,
    figures: 'The drive',
  },
} as const)
