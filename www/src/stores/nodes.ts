import type { Inspection, Point3 } from 'forage-lab'

export const NODES = 'nodes'

/** Where the node of a tree is that is looked at closer; null if it is none. */
export const nodeOf = ({ item, layers }: Inspection): Point3 | null =>
  (item.role === NODES && layers.find(({ role, shape }) => role === 'after' && shape === 'points')?.vertices[0]) || null
