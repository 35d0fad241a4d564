import {
  BufferAttribute,
  BufferGeometry,
  type Color,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  ShadowMaterial,
} from 'three'
import type { Cuboid } from 'forage-lab'
import { edging, settle, wire } from './boxes'

/** The lines of the floor lie so far apart, in metres. */
export const GRID = 0.1
const MOST_LINES = 400

/** The workspace: its edges, and a floor with a grid that shadows fall on. */
export class Room {
  readonly group = new Group()
  private readonly floor = new Mesh(
    new PlaneGeometry(1, 1),
    new MeshBasicMaterial({ polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 2 }),
  )
  private readonly shade = new Mesh(
    new PlaneGeometry(1, 1),
    new ShadowMaterial({ polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }),
  )
  private readonly grid = new LineSegments(new BufferGeometry(), new LineBasicMaterial())
  private readonly line = edging()
  private readonly edges = wire(this.line)

  constructor() {
    this.shade.receiveShadow = true
    this.floor.renderOrder = -4
    this.shade.renderOrder = -3
    this.group.add(this.floor, this.shade, this.grid, this.edges)
  }

  paint(floor: Color, grid: Color, edge: Color, shadow: number): void {
    this.floor.material.color.copy(floor)
    this.grid.material.color.copy(grid)
    this.line.color.copy(edge)
    this.line.linewidth = 1.25
    this.shade.material.opacity = shadow
  }

  show(workspace: Cuboid): void {
    const { min, max } = workspace
    settle(this.edges, workspace)
    for (const plane of [this.floor, this.shade]) settle(plane, { min, max: [max[0], max[1], min[2]] })
    this.shade.scale.z = this.floor.scale.z = 1
    const ends: number[] = []
    for (const [axis, other] of [
      [0, 1],
      [1, 0],
    ] as const) {
      for (const at of ticks(min[axis], max[axis], Math.max(GRID, (max[axis] - min[axis]) / MOST_LINES))) {
        for (const end of [min[other], max[other]]) {
          const point = [0, 0, min[2]]
          ;[point[axis], point[other]] = [at, end]
          ends.push(...point)
        }
      }
    }
    this.grid.geometry.dispose()
    this.grid.geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(Float32Array.from(ends), 3))
  }

  drop(): void {
    for (const { geometry, material } of [this.floor, this.shade, this.grid, this.edges]) {
      geometry.dispose()
      material.dispose()
    }
  }
}

/** Multiples of a step. */
export function ticks(from: number, to: number, step: number): number[] {
  const first = Math.ceil(from / step - 1e-9)
  const count = Math.floor(to / step + 1e-9) - first + 1
  return Array.from({ length: Math.max(0, count) }, (_, at) => (first + at) * step)
}
