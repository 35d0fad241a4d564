import type { Point, Point3 } from 'forage-lab'

/** What a recording's file says of itself. */
export interface Header {
  /** The smallest and the largest value of each of the four numbers of a vertex. */
  ranges: [number, number][]
  /** So many steps lie between them. */
  steps: number
  pictures: { iteration: number; vertices: number; spans: number }[]
  /** Of an arm: how its links hang together. */
  skeleton: Point3[]
  exact: Point[] | Point3[] | null
}

const COLUMNS = 4

/** Pictures of a run, made while the page was built. */
export class Recording {
  private readonly numbers: Uint16Array
  private readonly places: number[]

  constructor(
    readonly header: Header,
    body: ArrayBuffer,
    offset: number,
  ) {
    this.numbers = new Uint16Array(body, offset)
    let place = 0
    this.places = header.pictures.map(({ vertices, spans }) => {
      const own = place
      place += vertices + spans
      return own
    })
  }

  static read(file: ArrayBuffer): Recording {
    const length = new DataView(file).getUint32(0, true)
    const header = JSON.parse(new TextDecoder().decode(new Uint8Array(file, 4, length))) as Header
    return new Recording(header, file, 4 + length)
  }

  /** A picture as a frame's buffer. */
  picture(at: number): { buffer: ArrayBuffer; vertices: number; spans: number } {
    const { ranges, steps, pictures } = this.header
    const { vertices, spans } = pictures[at] ?? { vertices: 0, spans: 0 }
    const start = this.places[at] ?? 0
    const buffer = new ArrayBuffer((vertices + spans) * Float32Array.BYTES_PER_ELEMENT)
    const points = new Float32Array(buffer, 0, vertices)
    const count = vertices / COLUMNS
    ranges.forEach(([low, high], column) => {
      let value = 0
      for (let row = 0; row < count; row += 1) {
        value = (value + (this.numbers[start + column * count + row] ?? 0)) & 0xffff
        points[COLUMNS * row + column] = low + (value * (high - low)) / steps
      }
    })
    new Uint32Array(buffer, points.byteLength, spans).set(this.numbers.subarray(start + vertices, start + vertices + spans))
    return { buffer, vertices, spans }
  }
}
