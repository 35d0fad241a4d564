import { type Color, DynamicDrawUsage, GreaterDepth, Group, InstancedInterleavedBuffer, InterleavedBufferAttribute } from 'three'
import { LineMaterial } from 'three/addons/lines/LineMaterial.js'
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js'
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js'
import type { Look } from 'forage-lab'

/** How the strokes look, as far as their look doesn't say. */
export interface Ink {
  colour: Color
  /** The stage's, for what lifts strokes off what lies behind. */
  ground: Color
  /** How much of them is left. */
  alpha: number
  /** Lifted, and seen through what hides it. */
  result: boolean
}

const FIRST_ROOM = 256
/** Numbers a segment: two ends, and how far along the line each is. */
const [ENDS, LENGTHS] = [6, 2]
const HIDDEN = 0.3
const HALO = 3
/** Finer dots would be lost on the edges of a tree. */
const LEAST = { width: 2, dash: 3 }

/** Lines of one kind, as wide on the screen as their style says. Their buffers grow and are filled anew in place. */
export class Strokes {
  readonly group = new Group()
  private readonly geometry = new LineSegmentsGeometry()
  private readonly line = new LineMaterial()
  private readonly halo = new LineMaterial({ depthWrite: false })
  private readonly hidden = new LineMaterial({ depthWrite: false, depthFunc: GreaterDepth })
  private ends = new Float32Array()
  private lengths = new Float32Array()
  private count = 0

  constructor(order: number) {
    ;[this.hidden, this.halo, this.line].forEach((material, at) => {
      material.transparent = true
      const lines = new LineSegments2(this.geometry, material)
      // Their box would have to be found for each picture.
      lines.frustumCulled = false
      lines.renderOrder = order + at / 4
      this.group.add(lines)
    })
    this.room(FIRST_ROOM)
  }

  /** Begins anew. */
  clear(): void {
    this.count = 0
  }

  /** Vertices of four numbers each, joined in a row or in pairs. */
  add(vertices: Float32Array, first: number, count: number, joined: boolean): void {
    this.room(this.count + count)
    let along = 0
    for (let at = first; at + 1 < first + count; at += joined ? 1 : 2) {
      const [a, b, to] = [4 * at, 4 * (at + 1), ENDS * this.count]
      for (let axis = 0; axis < 3; axis += 1) {
        this.ends[to + axis] = vertices[a + axis] ?? 0
        this.ends[to + 3 + axis] = vertices[b + axis] ?? 0
      }
      if (!joined) along = 0
      this.lengths[LENGTHS * this.count] = along
      along += apart(vertices, a, b)
      this.lengths[LENGTHS * this.count + 1] = along
      this.count += 1
    }
  }

  /** What was added is what is shown. */
  done(): void {
    this.geometry.instanceCount = this.count
    for (const [name, size] of [
      ['instanceStart', ENDS],
      ['instanceDistanceStart', LENGTHS],
    ] as const) {
      const { data } = this.geometry.getAttribute(name) as InterleavedBufferAttribute
      data.clearUpdateRanges()
      data.addUpdateRange(0, size * this.count)
      data.needsUpdate = true
    }
  }

  look(style: Look, { colour, ground, alpha, result }: Ink): void {
    for (const material of [this.line, this.hidden]) {
      material.color.copy(colour)
      material.linewidth = result ? Math.max(style.width, LEAST.width) : style.width
      material.dashed = style.dash !== undefined
      material.dashSize = Math.max(style.dash?.[0] ?? 0, LEAST.dash)
      material.gapSize = style.dash?.[1] ?? 1
    }
    // The way along a tree lies on its edges, and wins over them.
    this.line.polygonOffset = result
    this.line.polygonOffsetUnits = -300
    this.line.opacity = alpha * style.opacity[0]
    this.hidden.opacity = alpha * HIDDEN
    this.halo.color.copy(ground)
    this.halo.linewidth = style.width + HALO
    this.halo.opacity = alpha * 0.75
    const [hidden, halo] = this.group.children
    if (hidden) hidden.visible = result
    if (halo) halo.visible = result && style.dash === undefined
  }

  /** Dashes are as long on the screen as their style says: `each` is a pixel in metres. */
  scale(each: number): void {
    for (const material of [this.line, this.hidden]) material.dashScale = 1 / each
  }

  private room(segments: number): void {
    const before = this.lengths.length / LENGTHS
    if (segments <= before) return
    const after = Math.max(segments, 2 * before)
    const grown = (array: Float32Array, size: number): Float32Array<ArrayBuffer> => {
      const next = new Float32Array(after * size)
      next.set(array)
      return next
    }
    this.ends = grown(this.ends, ENDS)
    this.lengths = grown(this.lengths, LENGTHS)
    // The old buffers leave the graphics memory.
    this.geometry.dispose()
    const attribute = (array: Float32Array, size: number, names: readonly [string, string]): void => {
      const buffer = new InstancedInterleavedBuffer(array, size, 1)
      buffer.setUsage(DynamicDrawUsage)
      for (const [at, name] of names.entries())
        this.geometry.setAttribute(name, new InterleavedBufferAttribute(buffer, size / 2, (at * size) / 2))
    }
    attribute(this.ends, ENDS, ['instanceStart', 'instanceEnd'])
    attribute(this.lengths, LENGTHS, ['instanceDistanceStart', 'instanceDistanceEnd'])
  }

  drop(): void {
    this.geometry.dispose()
    for (const material of [this.line, this.halo, this.hidden]) material.dispose()
  }
}

const apart = (vertices: Float32Array, a: number, b: number): number =>
  Math.hypot(
    (vertices[b] ?? 0) - (vertices[a] ?? 0),
    (vertices[b + 1] ?? 0) - (vertices[a + 1] ?? 0),
    (vertices[b + 2] ?? 0) - (vertices[a + 2] ?? 0),
  )

/** Points of three numbers as vertices of four. */
export function vertices(points: readonly (readonly [number, number, number])[]): Float32Array {
  return Float32Array.from(points.flatMap(([x, y, z]) => [x, y, z, 0]))
}
