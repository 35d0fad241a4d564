/* What has to do with stops: loaded with the first scene that has some. */
export { default as StopCard } from './StopCard.svelte'
export { default as StopTools } from './StopTools.svelte'
