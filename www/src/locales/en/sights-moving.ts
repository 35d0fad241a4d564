import type { presets } from './presets'

/** What there is to see in cases of drives: loaded with the first one that is chosen. */
export const sights: Readonly<Record<Extract<keyof typeof presets.cases, `moving-${string}`>, string>> = {
  'moving-ants':
    'Ants find a way of the published length. On it the robot foresees that the disc comes too near, and goes round it along the pheromone; the log tells when and why.',
  'moving-a-star':
    'The same drive on an exact way: soon after it sets out the robot foresees that the disc comes too near, and plans a new way to the goal.',
  'moving-printed':
    'The path that the paper prints, cell by cell, driven without a margin: its length, its turns and its time are the printed ones. The layer “Printed path” shows it beside any other path on this map.',
  'moving-d-star-lite': 'The same drive on another of the shortest ways: the disc is seen, and nothing has to be decided.',
}
