/* What has to do with grids: loaded with the first of them. */
export { Carrying } from './carrying'
export { Cells, drawCell } from './cells'
export { drawTubes, own } from './driven'
export { default as GridTools } from './GridTools.svelte'
export { insideCells } from './inside'
export { default as MoverCard } from './MoverCard.svelte'
export { default as MoverKeys } from './MoverKeys.svelte'
export { printedPath } from '../state/printed'
