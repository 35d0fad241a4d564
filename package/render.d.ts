import type { Catalogue, Session } from './forage.js'

/** How a run is drawn. What is left out is as it was, and at first as the page has it. */
export interface DrawingOptions {
  /** In pixels of the page; at first the canvas's own size there. */
  size?: { width: number; height: number }
  /** Pixels of the canvas a pixel of the page; at first the screen's, and 1 in a worker. */
  density?: number
  /** Colours for a dark page. */
  dark?: boolean
  /** Layers that are shown or hidden although their standard is otherwise, by their keys: `{ particles: false }`. */
  layers?: Readonly<Record<string, boolean>>
  /**
   * What is seen. Of the plane: the middle, in the scene's units, and how many times larger than with the whole scene in view. Of an
   * arm's scene: what is looked at and how far away, in metres, and from where, in degrees about z from x and above the floor. `null`:
   * all of it.
   */
  camera?:
    | { center: [number, number]; zoom: number }
    | { target: [number, number, number]; distance: number; azimuth: number; elevation: number }
    | null
  /** The most vertices that a layer may have. */
  budget?: number
  /** The names of start and goal. */
  labels?: { start: string; goal: string }
  /** What the planners draw; at first that of the package. With planners of one's own, theirs. */
  catalogue?: Catalogue
}

/** A canvas on which runs are drawn. */
export interface RunDrawing {
  /**
   * Draws the iteration that a session is at, as soon as the browser draws again.
   *
   * Throws an `Error` with `field`, `value` and `allowed` for a planner that the catalogue lacks and for layers that it has not.
   */
  draw(session: Session): void
  /** Changes how it is drawn. Throws, as `draw` does, for what is no size, density, budget or camera. */
  set(options: DrawingOptions): void
  /** What is drawn, as SVG with this title; fails before anything was drawn. All that is not an arm's scene in lines and areas, that one in parallel projection. */
  svg(caption?: string): Promise<string>
  /** What is drawn, as a PNG with so many pixels a pixel of the page; at first those of the canvas. */
  png(density?: number): Promise<Blob>
  /** Ends it. */
  dispose(): void
}

/**
 * Draws runs as the page does, on a canvas of a page, or on an `OffscreenCanvas` in a worker, which nothing else has drawn.
 *
 * ```js
 * import init, { Session } from 'forage-lab'
 * import { drawOn } from 'forage-lab/render'
 *
 * await init()
 * const session = new Session({ planner: 'pso', scene: 'sphere-2', seed: 4 })
 * const drawing = drawOn(document.querySelector('canvas'))
 * session.step(20)
 * drawing.draw(session)
 * ```
 */
export function drawOn(canvas: HTMLCanvasElement | OffscreenCanvas, options?: DrawingOptions): RunDrawing
