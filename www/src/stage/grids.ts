/* What has to do with grids: loaded with the first of them. */
export { Carrying } from './carrying'
export { Cells } from './cells'
export { drawTubes, own } from './driven'
export { insideCells } from './inside'
export { default as MoverCard } from './MoverCard.svelte'
export { default as MoverKeys } from './MoverKeys.svelte'
export { default as MoverTool } from './MoverTool.svelte'
