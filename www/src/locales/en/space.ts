import { texts } from '../texts'

const metres = (value: number): string => `${Number(value.toFixed(3))}`.replace('-', '−')

export const space = texts('space', {
  label: 'Stage in space: the arm, its workspace and what the planner makes of it',
  words: ({ size, cuboids, nodes, length, from, to }: Words): string =>
    [
      `Workspace of ${size.map(metres).join(' × ')} metres, ${cuboids === 1 ? '1 cuboid' : `${cuboids} cuboids`}.`,
      `From ${point(from)} to ${point(to)}.`,
      nodes === null ? '' : nodes === 1 ? 'The tree has 1 node.' : `The tree has ${nodes} nodes.`,
      length === null ? 'There is no path yet.' : `A path of ${metres(length)} metres was found.`,
    ]
      .filter(Boolean)
      .join(' '),
  selected: (name: string, at: readonly number[]): string => `${name}, at ${point(at)}`,
  cuboid: (index: number): string => `cuboid ${index + 1}`,
  start: 'start',
  goal: 'goal',
  base: 'base',
  axes: ['x', 'y', 'z'] as const,
  unit: 'm',
  tools: 'Stage tools',
  add: 'Add a cuboid',
  remove: 'Delete the selected cuboid',
  zoomIn: 'Zoom in',
  zoomOut: 'Zoom out',
  fit: 'Show all',
  views: 'Views',
  sides: { corner: 'From a corner', front: 'From the front', side: 'From the side', top: 'From above' },
  hint: 'Drag it over the floor; its arrow or Shift lifts it, its dots move the faces.',
  lift: 'Drag it over the floor; its arrow or Shift lifts it.',
  thinned: (n: number) => `1 of ${n} drawn`,
  failed: 'This browser can’t draw in space',
  why: 'The 3D stage needs WebGL 2, and the browser doesn’t provide it: hardware acceleration may be switched off in its settings. All else works: the run, its numbers, the scene’s tables, exports.',
  lost: 'The graphics card has dropped the picture; it comes back by itself as soon as the card is free.',
})

interface Words {
  size: readonly number[]
  cuboids: number
  nodes: number | null
  length: number | null
  from: readonly number[]
  to: readonly number[]
}

const point = (at: readonly number[]): string => `(${at.map(metres).join(', ')})`
