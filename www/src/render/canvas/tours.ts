/* What has to do with stops: loaded with the first scene that has some. */
export { drawArrows } from './arrows'
export { drawStops } from './stops'
