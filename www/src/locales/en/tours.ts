import { texts } from '../texts'

/** Text about tours and those that search side by side: loaded when there are any. */
export const tours = texts('tours', {
  step: (title: string, k: string, of: string, runs: string) => `${title} ${k} of ${of}: ${runs}`,
  order: {
    title: (stops: string) => `Order of the ${stops} stops`,
    numbers: 'The stops’ numbers in the scene; the stage counts along the tour.',
    copy: 'Copy the order',
    copied: 'Copied',
    failed: 'Copying was not allowed.',
  },
  members: {
    waiting: 'They begin to search as soon as the roads are built.',
    none: 'Nothing is known of them before the first step.',
    number: 'Number',
    sort: (title: string) => `${title} (click to sort)`,
    range: (least: string, mean: string, most: string) => `${least} … ${most}, mean ${mean}`,
    row: (name: string, numbers: string) => `${name}: ${numbers}`,
    layer: (title: string) => `Show on the stage: ${title.toLowerCase()}`,
    pick: 'Click a bar to look closer',
    hint: 'Click a row, or press Enter on it, to look closer.',
  },
} as const)
