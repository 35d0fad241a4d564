import type { presets } from './presets'

/** What there is to see in cases: loaded with the first one that is chosen. Those of arms and of drives are in sights-arm.ts and sights-moving.ts. */
export const sights: Readonly<Record<Exclude<keyof typeof presets.cases, `${'arm' | 'moving'}-${string}`>, string>> = {
  crossing: 'Discs cross a hall from both sides: each detour is a decision with a time, a place and a reason.',
  patrol: 'Where a guard stands in a door there is no way round: the robot waits until the way is clear.',
  corridor: 'Neither a way round nor standing still is safe: the robot backs into a niche and lets the disc pass.',
  misled:
    'With the published parameters ants follow the rank of a cell, even where walls lead away from the goal: the colony agrees on a path that is much too long. The default parameters weigh the rank less.',
  direction: 'Ants that mind where the goal lies are on a shortest way within a few iterations.',
  quantum: 'Particles leap about their attractors, less far as the run goes on; the robot can drive along the result.',
  hens: 'Particles that stagnate are perturbed (the paper’s hen and chick moves); the exact optimum is 12.1416.',
}
