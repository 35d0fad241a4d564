/* What has to do with grids: loaded with the first of them. */
export { Cells, drawCell } from './cells'
export { drawRobots, drawTubes, own } from './driven'
export { drawEvents } from './events'
export { drawMovers } from './movers'
export { insideCells } from './overlap-cells'
