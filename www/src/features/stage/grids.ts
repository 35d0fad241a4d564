/* What has to do with grids: loaded with the first of them. */
export { MovingPointer } from './moving-pointer'
export { default as DriveTool } from './DriveTool.svelte'
export { default as GridTools } from './GridTools.svelte'
export { default as MoverCard } from './MoverCard.svelte'
export { default as MoverKeys } from './MoverKeys.svelte'
export { grids as text } from '../../locales/en/grids'
export { printedPath } from '../../scene/printed-path'
