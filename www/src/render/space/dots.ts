import { BufferAttribute, BufferGeometry, CanvasTexture, type Color, DynamicDrawUsage, Points, PointsMaterial } from 'three'
import type { Look, Point3 } from 'forage-lab'
import { colorOf } from '../palette'

const SIDE = 64
type Mark = Look['glyph']
const marks = new Map<Mark, CanvasTexture<OffscreenCanvas>>()

/** What a point looks like: round, unless it has a mark of its own. */
export function form(mark?: Mark): CanvasTexture<OffscreenCanvas> {
  const known = marks.get(mark)
  if (known) return known
  const canvas = new OffscreenCanvas(SIDE, SIDE)
  const context = canvas.getContext('2d')
  if (context) draw(context, mark)
  const texture = new CanvasTexture(canvas)
  marks.set(mark, texture)
  return texture
}

function draw(context: OffscreenCanvasRenderingContext2D, mark: Mark): void {
  const [middle, rim, width] = [SIDE / 2, 2, 13]
  context.strokeStyle = context.fillStyle = colorOf('--light').light
  context.lineWidth = width
  context.beginPath()
  if (mark === 'diamond') {
    for (const [x, y] of [
      [0, -1],
      [1, 0],
      [0, 1],
      [-1, 0],
    ] as const)
      context.lineTo(middle + x * (middle - width), middle + y * (middle - width))
    context.closePath()
    context.stroke()
  } else if (mark === 'ring' || mark === 'number') {
    context.arc(middle, middle, middle - rim - width / 2, 0, 2 * Math.PI)
    context.stroke()
  } else {
    context.arc(middle, middle, middle - rim, 0, 2 * Math.PI)
    context.fill()
  }
}

/** Points of one kind, as large on the screen as their style says. */
export class Dots {
  readonly points: Points<BufferGeometry, PointsMaterial>
  /** Three numbers each. */
  places = new Float32Array(3 * 256)
  count = 0

  constructor(order: number) {
    const material = new PointsMaterial({ sizeAttenuation: false, map: form(), alphaTest: 0.5, transparent: true })
    this.points = new Points(new BufferGeometry(), material)
    this.points.frustumCulled = false
    this.points.renderOrder = order
    this.attach()
  }

  clear(): void {
    this.count = 0
  }

  add(vertices: Float32Array, first: number, count: number): void {
    if (3 * (this.count + count) > this.places.length) {
      const grown = new Float32Array(3 * Math.max(this.count + count, (2 * this.places.length) / 3))
      grown.set(this.places)
      this.places = grown
      this.points.geometry.dispose()
      this.attach()
    }
    for (let at = 0; at < count; at += 1) {
      const [from, to] = [4 * (first + at), 3 * (this.count + at)]
      for (let axis = 0; axis < 3; axis += 1) this.places[to + axis] = vertices[from + axis] ?? 0
    }
    this.count += count
  }

  done(): void {
    const { geometry } = this.points
    geometry.setDrawRange(0, this.count)
    const places = geometry.getAttribute('position') as BufferAttribute
    places.clearUpdateRanges()
    places.addUpdateRange(0, 3 * this.count)
    places.needsUpdate = true
  }

  /** Where a point is. */
  at(index: number): Point3 {
    const [x = 0, y = 0, z = 0] = this.places.subarray(3 * index, 3 * index + 3)
    return [x, y, z]
  }

  look(colour: Color, mark: Mark, size: number, alpha: number): void {
    const { material } = this.points
    material.map = form(mark)
    material.color.copy(colour)
    material.size = size
    material.opacity = alpha
    // What is faint has the same rim.
    material.alphaTest = alpha / 2
  }

  private attach(): void {
    const places = new BufferAttribute(this.places, 3)
    places.setUsage(DynamicDrawUsage)
    this.points.geometry.setAttribute('position', places)
  }

  drop(): void {
    this.points.geometry.dispose()
    this.points.material.dispose()
  }
}
