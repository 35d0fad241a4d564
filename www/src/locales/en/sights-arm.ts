import type { presets } from './presets'

/** What there is to see in cases of arms: loaded with the first one that is chosen. */
export const sights: Readonly<Record<Extract<keyof typeof presets.cases, `arm-${string}`>, string>> = {
  'arm-guided':
    'The tree runs nearly straight to the goal. Click a node to see its twenty samples, the four that were kept and what the roulette wheel chose.',
  'arm-guided-wide': 'The same with longer steps: fewer nodes, and the end comes sooner.',
  'arm-basic': 'A basic tree fills the workspace before it comes to the goal; compare the number of nodes with the guided one’s.',
  'arm-cuboid': 'The tree slides along the cuboid. Let the arm follow the path: the verdict is of the whole arm, not of its tip alone.',
  'arm-cuboid-basic': 'The basic tree goes everywhere: more nodes and a longer raw path, and hardly longer after it was shortened.',
  'arm-star': 'The first path comes soon; then the tree is rewired, and the path comes near to the tip’s shortest way.',
  'arm-joints':
    'The way it is done today: two trees of postures, and the whole arm keeps clear. The same tree is shown in pairs of joints and in space.',
  'arm-puma':
    'A common arm with a spherical wrist, given as data alone: its postures, its motion and where its tip can come follow from the table.',
}
