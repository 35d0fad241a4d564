import { host } from '../engine/host'
import { Renderers } from '../render/renderers'

/** All canvases of the page are drawn by one thread. */
export const renderers = new Renderers(() => host().worker('render'))
