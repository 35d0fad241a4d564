/* What is used of gifenc, which has no types of its own. */
declare module 'gifenc' {
  type Colours = [red: number, green: number, blue: number][]
  interface Encoder {
    writeFrame(
      index: Uint8Array,
      width: number,
      height: number,
      options: { palette: Colours; delay: number; transparent?: boolean; transparentIndex?: number; dispose?: number },
    ): void
    finish(): void
    bytes(): Uint8Array<ArrayBuffer>
  }
  export function GIFEncoder(): Encoder
  export function quantize(rgba: Uint8Array | Uint8ClampedArray, colours: number, options?: { format: 'rgb565' | 'rgb444' }): Colours
  export function applyPalette(rgba: Uint8Array | Uint8ClampedArray, palette: Colours, format?: 'rgb565' | 'rgb444'): Uint8Array
}
