/** A kind of file that is written. */
export interface Encoder {
  /** The canvas as it is now, as the next picture. */
  add(): Promise<void>
  /** All pictures, as a file. */
  end(): Promise<Blob>
  /** Nobody wants it any more. */
  cancel(): Promise<void>
}

/** What is drawn on before it is encoded. */
export type FilmContext = OffscreenCanvasRenderingContext2D
