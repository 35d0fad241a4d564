import { BoxGeometry, type Color, Group, Mesh, MeshStandardMaterial } from 'three'
import { LineMaterial } from 'three/addons/lines/LineMaterial.js'
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js'
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js'
import type { Cuboid } from 'forage-lab'

export type Mood = 'plain' | 'hover' | 'selected' | 'wrong'
export type Paint = Readonly<Record<Mood, { side: Color; edge: Color; width: number }>>

const UNIT = [-0.5, 0.5] as const
/** The twelve edges of the unit cube. */
const EDGES = [0, 1, 2].flatMap((axis) =>
  UNIT.flatMap((u) =>
    UNIT.flatMap((v) =>
      UNIT.flatMap((along) => {
        const at = [0, 0, 0]
        ;[at[axis], at[(axis + 1) % 3], at[(axis + 2) % 3]] = [along, u, v]
        return at
      }),
    ),
  ),
)

/** Lines lie on the sides they bound, and on the floor: they win over both. */
export const edging = (): LineMaterial =>
  new LineMaterial({ transparent: true, polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -500 })

/** The edges of a box that is scaled and put in place. */
export function wire(material: LineMaterial): LineSegments2 {
  const geometry = new LineSegmentsGeometry()
  geometry.setPositions(EDGES)
  return new LineSegments2(geometry, material)
}

/** The cuboids of a scene: as many meshes as needed, used again. */
export class Boxes {
  readonly group = new Group()
  private readonly shape = new BoxGeometry(1, 1, 1)
  private readonly sides = new Map<Mood, MeshStandardMaterial>()
  private readonly edges = new Map<Mood, LineMaterial>()
  private readonly all: { solid: Mesh; wire: LineSegments2 }[] = []

  constructor() {
    for (const mood of ['plain', 'hover', 'selected', 'wrong'] as const) {
      this.sides.set(
        mood,
        new MeshStandardMaterial({ roughness: 0.85, metalness: 0, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }),
      )
      this.edges.set(mood, edging())
    }
  }

  paint(paint: Paint): void {
    for (const [mood, { side, edge, width }] of Object.entries(paint) as [Mood, Paint[Mood]][]) {
      this.sides.get(mood)?.color.copy(side)
      const line = this.edges.get(mood)
      line?.color.copy(edge)
      if (line) line.linewidth = width
    }
  }

  show(cuboids: readonly Cuboid[], moodOf: (index: number) => Mood): void {
    while (this.all.length < cuboids.length) {
      const solid = new Mesh(this.shape)
      solid.castShadow = solid.receiveShadow = true
      const lines = wire(new LineMaterial())
      this.group.add(solid, lines)
      this.all.push({ solid, wire: lines })
    }
    this.all.forEach(({ solid, wire: lines }, index) => {
      const cuboid = cuboids[index]
      solid.visible = lines.visible = cuboid !== undefined
      if (!cuboid) return
      const mood = moodOf(index)
      solid.material = this.sides.get(mood) ?? solid.material
      lines.material = this.edges.get(mood) ?? lines.material
      for (const object of [solid, lines]) settle(object, cuboid)
    })
  }

  drop(): void {
    this.shape.dispose()
    for (const material of [...this.sides.values(), ...this.edges.values()]) material.dispose()
    for (const { wire: lines } of this.all) lines.geometry.dispose()
  }
}

/** Puts a unit box where a cuboid is. */
export function settle(object: Mesh, { min, max }: Cuboid): void {
  object.position.set((min[0] + max[0]) / 2, (min[1] + max[1]) / 2, (min[2] + max[2]) / 2)
  object.scale.set(max[0] - min[0], max[1] - min[1], max[2] - min[2])
}
