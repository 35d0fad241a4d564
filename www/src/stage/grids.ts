/* What has to do with grids: loaded with the first of them. */
export { Cells } from './cells'
export { insideCells } from './inside'
