/* What has to do with stops: loaded with the first scene that has some. */
export { drawArrows } from '../../render/canvas/arrows'
export { default as StopCard } from './StopCard.svelte'
export { default as StopTools } from './StopTools.svelte'
export { drawStops, placesOf } from '../../render/canvas/stops'
