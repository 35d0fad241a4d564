import { BufferAttribute, BufferGeometry, MathUtils, Points, PointsMaterial } from 'three'
import type { Reachability } from 'forage-lab'
import type { Palette } from '../palette'
import { colourOf, mixed } from './colors'
import { form } from './dots'
import { FIELD_OF_VIEW } from './orbit'

/** How large a point is beside the distance of neighbours; the library's unit is that of a lens of 90°. */
const SIZE = 0.14 / Math.tan(MathUtils.degToRad(FIELD_OF_VIEW / 2))
/** Four numbers a point: where it is, and the share of directions. */
const POINT = 4

/** Where the tip can come: a point for each place of a lattice, the stronger the more ways the tool may point there. */
export class Cloud {
  readonly points = new Points(new BufferGeometry(), new PointsMaterial({ vertexColors: true, map: form(), alphaTest: 0.5 }))

  constructor() {
    this.points.visible = false
  }

  show(reach: Reachability | null, palette: Palette): void {
    const [weak, strong] = [mixed(colourOf(palette, '--guide'), colourOf(palette, '--stage'), 0.35), colourOf(palette, '--attractor')]
    this.points.visible = reach !== null
    this.points.geometry.dispose()
    if (!reach) return
    const places: number[] = []
    const colours: number[] = []
    for (let at = 0; at + 3 < reach.points.length; at += POINT) {
      const [x = 0, y = 0, z = 0, share = 0] = reach.points.subarray(at, at + POINT)
      if (share <= 0) continue
      places.push(x, y, z)
      colours.push(...mixed(weak, strong, share).toArray())
    }
    this.points.material.size = SIZE * reach.step
    this.points.geometry = new BufferGeometry()
      .setAttribute('position', new BufferAttribute(Float32Array.from(places), 3))
      .setAttribute('color', new BufferAttribute(Float32Array.from(colours), 3))
  }

  drop(): void {
    this.points.geometry.dispose()
    this.points.material.dispose()
  }
}
