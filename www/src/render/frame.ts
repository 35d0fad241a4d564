/* What crosses from a run to its picture. */
import type { Point, Ramp, Scene } from 'forage-lab'

/** A run's layers at one iteration. It has one owner at a time: host, page, renderer. */
export interface Frame {
  /** `vertices` floats (x, y, z and weight of each vertex), then the span table; goes back to the run's pool. */
  buffer: ArrayBuffer
  vertices: number
  /** Numbers of the span table: layer, shape, first vertex and count of each span. */
  spans: number
  /** The fields that are shown. Their bitmaps are to be closed when they were drawn for the last time. */
  fields: FieldPicture[]
}

/** What a frame's buffer holds. */
export type Layers = Pick<Frame, 'buffer' | 'vertices' | 'spans'>

export const verticesOf = ({ buffer, vertices }: Layers): Float32Array => new Float32Array(buffer, 0, vertices)
export const spansOf = ({ buffer, vertices, spans }: Layers): Uint32Array => new Uint32Array(buffer, vertices * 4, spans)

/** What of a run is seen. Frames depend on it. */
export interface Viewport {
  /** The fields that are shown, with their colours. */
  fields: { role: string; ramp: Ramp }[]
  /** The part of the plane that is seen, where a layer is only worth drawing from near; null: all of it. */
  window: { min: Point; max: Point } | null
}

/** A layer of values over the plane, coloured: a pixel a value, the row of the smallest y first. */
export interface FieldPicture {
  role: string
  bitmap: ImageBitmap
  min: Point
  max: Point
  /** The smallest and the largest value. */
  range: [number, number]
}

/** The heights of a function, coloured. */
export interface HeightMap {
  bitmap: ImageBitmap
  /** The values of the first colour, of the one in the middle and of the last. */
  heights: readonly number[]
}

/** Asks for the heights of a function, coloured. */
export interface FieldRequest {
  scene: Scene
  min: Point
  max: Point
  width: number
  height: number
  ramp: Ramp
}
