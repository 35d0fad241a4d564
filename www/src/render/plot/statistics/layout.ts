/** Heights of a row and its parts, in pixels. */
export const ROW = { height: 92, box: 24, boxHeight: 18, dots: 48, dotsHeight: 38 }
export const PADDING = { top: 6, bottom: 28, side: 14, strip: 92 }

/** Runs with neighbouring seeds lie apart, and each always at the same place: multiples of the golden ratio. */
export const jitter = (seed: number, ratio: number): number => (seed * ratio) % 1
export const [GOLDEN, PLASTIC] = [0.618033988749895, 0.754877666246693]
