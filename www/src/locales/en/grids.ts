import { texts } from '../texts'

/** Text of the stage’s tools and layers for grids: loaded with the first grid. */
export const grids = texts('grids', {
  look: 'Look around: drag to move the view, click to look closer',
  paint: 'Paint cells',
  clear: 'Clear: remove all walls',
  cells: 'Go from cell to cell with the arrow keys',
  painting: 'Drag over free cells to paint, over blocked ones to erase. The right button or two fingers move the view.',
  cell: (column: number, row: number, blocked: boolean) => `Column ${column}, row ${row} from the top: ${blocked ? 'blocked' : 'free'}`,
  drive: 'Let the robot drive along the path',
  margin: 'Inflated obstacles',
  marginHelp: 'Where the robot’s centre may not be: nearer to a blocked cell than the robot’s radius.',
  moving: 'Moving obstacles',
  movingHelp: 'Where they begin, and where they go in a second.',
} as const)
